// What a figure compares: BRDFs, each with one value of every sweep.
#pragma once

#include <string>
#include <vector>

namespace relume {

struct Setting {
  std::string parameter, value;  ///< as `--set PARAM=VALUE` has them
};

/// A BRDF with constants.
struct Subject {
  std::string brdf;
  std::vector<Setting> settings;  ///< those that it takes, in the order that they were asked for

  std::vector<std::string> assignments() const;
  /// The value of a parameter; empty where it takes none.
  std::string value(const std::string& parameter) const;
};

/// A parameter with the values that it is to have.
struct Sweep {
  std::string parameter;
  std::vector<std::string> values;
  bool varies() const { return values.size() > 1; }
};

struct Comparison {
  std::vector<Subject> subjects;
  std::vector<Sweep> sweeps;  ///< parameters with one value among them

  /// "phong, exponent = 8": the name and what varies.
  std::string label(const Subject& subject) const;
  /// "ks = 0.5": what does not vary.
  std::string constants() const;
};

/// `set`: PARAM=VALUE[,VALUE...], or PARAM=VALUE;VALUE... where a value is r,g,b. Every BRDF with every combination of the values of the parameters
/// that it takes; one that takes none of them stands there once. Error{input} for a parameter that none takes, and for more than `most` subjects.
Comparison compared(const std::vector<std::string>& brdfs, const std::vector<std::string>& set, std::size_t most);

}  // namespace relume
