// ProgressBar: one line, redrawn when its whole per cent changes.
#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace relume {

ProgressBar::ProgressBar(bool wanted) : visible_(wanted && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (visible_ && last_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const std::string& stage, double share) {
  const int percent = int(100 * std::clamp(share, 0.0, 1.0));
  if (!visible_ || (percent == last_ && stage == stage_)) return;
  last_ = percent;
  stage_ = stage;
  const std::string done(std::size_t(percent) * 40 / 100, '#');
  std::fprintf(stderr, "\r\033[K%-8s [%-40s] %3d%%", stage.c_str(), done.c_str(), percent);
}

}  // namespace relume
