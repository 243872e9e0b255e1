// How values become lengths or colours: linear, logarithmic or by the cube root, with round numbers to label.
#pragma once

#include <string>
#include <vector>

namespace relume {

enum class ScaleKind { linear, log, cube_root };

const char* name_of(ScaleKind kind);

/// The least of 1, 2, 2.5 and 5 times powers of ten that is not below `value`.
double rounded_up(double value);

/// "0.25", "1e+06": a mark beside a picture.
std::string mark_text(double mark);

class Scale {
 public:
  /// Room for values up to `peak`; one that is not above 0 counts as 1. A logarithmic scale has at least so many decades, as round ones.
  Scale(ScaleKind kind, double peak, int decades = 4);

  /// 0 at the lowest value, 1 at highest().
  double operator()(double value) const;
  double highest() const { return highest_; }
  /// Round values in 0..highest(), ascending; the highest is one of them.
  std::vector<double> marks() const;
  ScaleKind kind() const { return kind_; }

 private:
  ScaleKind kind_;
  int decades_;
  double highest_, lowest_ = 0, step_ = 0;
};

}  // namespace relume
