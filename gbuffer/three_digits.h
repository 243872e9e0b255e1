// A number for a sentence.
#pragma once

#include <cstdio>
#include <string>

namespace relume {

/// "0.994", "1.2e+06"
inline std::string three_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

}  // namespace relume
