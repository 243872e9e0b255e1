// What `relume bench` is asked to do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/rounds.h"
#include "host/device.h"

namespace relume::bench {

struct Size {
  int width, height;
};

struct Options {
  std::optional<std::string> filter;  ///< a regular expression on names; with it every dimension that no option narrows is open
  std::vector<std::string> devices;   ///< selectors of host/device.h, or "all"; empty: the best there is
  std::vector<Precision> precisions{Precision::exact};
  std::vector<int> lanes, lights;  ///< empty: the chosen ones, or all
  std::vector<Size> sizes;
  std::vector<std::string> brdfs;
  RoundOptions rounds;
  bool list = false;   ///< names alone
  bool costs = false;  ///< counted operations alone
  std::optional<std::filesystem::path> json, csv, plots, baseline;
};

}  // namespace relume::bench
