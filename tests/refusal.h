// What tests of input files share: text handed over as standard input, and the error that an action ends in.
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <sstream>
#include <string>

#include "gbuffer/error.h"

namespace relume {

/// std::cin reads from a text for as long as this lives.
class StandardInput {
 public:
  explicit StandardInput(const std::string& text) : text_(text), before_(std::cin.rdbuf(text_.rdbuf())) {}
  ~StandardInput() { std::cin.rdbuf(before_); }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  std::istringstream text_;
  std::streambuf* before_;
};

/// The whole message of the Error{input}, or "no error".
template <typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, ErrorKind::input);
    return error.what();
  }
  return "no error";
}

/// The error without the place that it must begin with.
inline std::string after(const std::string& place, const std::string& error) {
  return error.starts_with(place) ? error.substr(place.size()) : "not at \"" + place + "\": " + error;
}

}  // namespace relume
