// Reads whole channels of an EXR for a test, through our own reader.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gbuffer/exr_file.h"

namespace relume {

using Channels = std::map<std::string, std::vector<float>>;

/// Channel name -> samples of its part's data window, row by row; names as in the file, first part that has one wins.
inline Channels read_channels(const std::filesystem::path& path) {
  const ExrFile file(path);
  Channels all;
  for (const Part& part : file.parts())
    for (const Channel& channel : part.channels) {
      if (all.contains(channel.name)) continue;
      std::vector<float>& values = all[channel.name];
      values.resize(std::size_t(part.data_window.pixels()));
      const Destination to{channel.name, SampleType::float32, values.data(), sizeof(float), sizeof(float) * std::size_t(part.data_window.width())};
      file.read(part.index, part.data_window, {&to, 1});
    }
  return all;
}

}  // namespace relume
