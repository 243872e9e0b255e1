// Scale: which values stand where, and which of them are round.
#include "lab/scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace relume {

const char* name_of(ScaleKind kind) { return kind == ScaleKind::linear ? "linear" : kind == ScaleKind::log ? "log" : "cube root"; }

double rounded_up(double value) {
  const double ten = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 2.5, 5.0})
    if (value <= digit * ten * (1 + 1e-9)) return digit * ten;
  return 10 * ten;
}

std::string mark_text(double mark) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", mark);
  return text;
}

Scale::Scale(ScaleKind kind, double peak, int decades) : kind_(kind), decades_(decades) {
  const double top = peak > 0 && std::isfinite(peak) ? peak : 1;
  step_ = rounded_up(top / 5);  // four or five marks
  highest_ = kind == ScaleKind::linear ? step_ * std::ceil(top / step_ * (1 - 1e-9)) : rounded_up(top);
  if (kind == ScaleKind::log) lowest_ = std::pow(10, std::floor(std::log10(highest_) + 1e-9) - decades);
}

double Scale::operator()(double value) const {
  if (!(value > lowest_)) return 0;
  if (kind_ == ScaleKind::log) return std::log(value / lowest_) / std::log(highest_ / lowest_);
  return kind_ == ScaleKind::linear ? value / highest_ : std::cbrt(value / highest_);
}

std::vector<double> Scale::marks() const {
  std::vector<double> marks;
  if (kind_ == ScaleKind::linear) {
    for (int k = int(std::lround(highest_ / step_)); k >= 0; --k) marks.push_back(k * step_);
  } else {
    marks.push_back(highest_);
    const double ten = std::pow(10, std::floor(std::log10(highest_) + 1e-9));
    constexpr double apart = 0.12;  // of the whole length: room for a label
    for (int decade = 0; decade <= decades_; ++decade)
      for (const double digit : kind_ == ScaleKind::log ? std::vector{1.0} : std::vector{5.0, 2.0, 1.0})
        if (const double mark = digit * ten * std::pow(10, -decade); mark < highest_ && (*this)(marks.back()) - (*this)(mark) >= apart)
          marks.push_back(mark);
  }
  std::reverse(marks.begin(), marks.end());
  return marks;
}

}  // namespace relume
