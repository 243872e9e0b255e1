// The numbers behind a figure: a row for each sample, as CSV.
#pragma once

#include <string>
#include <vector>

#include "lab/brdf.h"
#include "lab/subject.h"

namespace relume {

/// "1.59154943"
std::string nine_digits(double number);

class SampleTable {
 public:
  /// `places`: columns that tell where a sample lies; `values`: columns of what was found there.
  SampleTable(const Comparison& comparison, const std::vector<std::string>& places, const std::vector<std::string>& values);

  /// Both in the order of their columns.
  void add(const Subject& subject, const std::vector<double>& places, const std::vector<double>& values);
  std::string csv() const { return text_; }

 private:
  const Comparison& comparison_;
  std::string text_;
};

/// "f_r.r" ... "f_r.specular.b", "reflectance.r" ...: of the total and both lobes.
std::vector<std::string> brdf_columns();
std::vector<double> brdf_values(const Reflectance& value, double n_l);

}  // namespace relume
