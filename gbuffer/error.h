// The one error type: what went wrong, in a line for the person at the other end, and the exit code it ends in.
#pragma once

#include <stdexcept>
#include <string>

namespace relume {

/// The documented exit codes (FORMATS: "Exit codes and errors").
enum class ErrorKind {
  input = 2,     ///< usage, or a bad input file
  device = 3,    ///< no usable device, or it failed its self-test
  memory = 4,    ///< the budget does not hold the work
  output = 5,    ///< the output could not be written; what was there before is untouched
  internal = 70  ///< a defect of ours
};

/// Form of the message: place, then what is wrong, then what is allowed. One line.
struct Error : std::runtime_error {
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind(kind) {}
  ErrorKind kind;
};

}  // namespace relume
