// One sample of a file's rows for all the questions that understanding it takes: a layer is decoded once, however many ask for it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gbuffer/sample_rows.h"

namespace relume {

class Samples {
 public:
  /// `file` must outlive it.
  explicit Samples(const ExrFile& file) : file_(file) {}

  const ExrFile& file() const { return file_; }

  /// As sample_rows() gives them: the roles that every file is asked about (position, normal, base_normal, depth, coverage, ids) and `more`, as far
  /// as the reading has them. They stand until the next call.
  const std::vector<SampledBand>& bands(const Reading& reading, const std::vector<std::string>& more = {});

 private:
  void forget_other_layers(const Reading& reading);

  const ExrFile& file_;
  Window window_;
  std::map<std::string, RoleLayer> held_;  ///< what the bands' planes were read from, by role
  std::vector<SampledBand> bands_;
};

}  // namespace relume
