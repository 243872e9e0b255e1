// A progress bar on a terminal, and nothing where stderr is none. (Debian 12 packages no progress-bar library for C++.)
#pragma once

#include <string>

namespace relume {

class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();  ///< clears the line
  void show(const std::string& stage, double share);

 private:
  bool visible_;
  int last_ = -1;
  std::string stage_;
};

}  // namespace relume
