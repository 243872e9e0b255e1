// Samples: reads what is not held yet, and what the reading takes from another layer than before.
#include "gbuffer/samples.h"

namespace relume {
namespace {

bool same_channels(const RoleLayer& a, const RoleLayer& b) { return a.part == b.part && a.channels == b.channels; }

}  // namespace

const std::vector<SampledBand>& Samples::bands(const Reading& reading, const std::vector<std::string>& more) {
  forget_other_layers(reading);
  // All at once: the channels of a block are compressed together, so that a second look costs as much as the first.
  std::vector<std::string> missing{"position", "normal", "base_normal", "depth", "coverage", "ids"};
  missing.insert(missing.end(), more.begin(), more.end());
  std::erase_if(missing, [&](const std::string& role) { return held_.contains(role) || !reading.roles.contains(role); });
  if (missing.empty() && !bands_.empty()) return bands_;
  std::vector<SampledBand> read = sample_rows(file_, reading, missing);
  if (bands_.empty())
    bands_ = std::move(read);
  else
    for (std::size_t i = 0; i < read.size(); ++i) bands_[i].planes.merge(read[i].planes);
  for (const std::string& role : missing) held_[role] = reading.roles.at(role);
  return bands_;
}

void Samples::forget_other_layers(const Reading& reading) {
  if (!(reading.data_window == window_)) {
    bands_.clear();
    held_.clear();
    window_ = reading.data_window;
  }
  std::erase_if(held_, [&](const auto& held) {
    const auto now = reading.roles.find(held.first);
    if (now != reading.roles.end() && same_channels(now->second, held.second)) return false;
    for (SampledBand& band : bands_) band.planes.erase(held.first);
    return true;
  });
}

}  // namespace relume
