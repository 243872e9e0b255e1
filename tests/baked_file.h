// A baked G-buffer back in memory, for tests: planes of one part by channel name.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "gbuffer/exr_file.h"

namespace relume {

struct StoredPart {
  Window window;
  std::map<std::string, std::vector<float>> planes;

  StoredPart(const std::filesystem::path& path, int part) {
    const ExrFile file(path);
    window = file.parts().at(std::size_t(part)).data_window;
    std::vector<Destination> all;
    for (const Channel& channel : file.parts()[std::size_t(part)].channels) {
      std::vector<float>& plane = planes[channel.name];
      plane.resize(std::size_t(window.pixels()));
      all.push_back({channel.name, SampleType::float32, plane.data(), sizeof(float), sizeof(float) * std::size_t(window.width())});
    }
    file.read(part, window, all);
  }

  float value(const std::string& channel, std::int64_t i) const { return planes.at(channel)[std::size_t(i)]; }
  glm::dvec3 vector(const std::string& layer, std::int64_t i) const {
    return {value(layer + ".X", i), value(layer + ".Y", i), value(layer + ".Z", i)};
  }
};

/// Degrees between two directions, which need not be unit: no cosine near 1 is taken.
inline double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / 3.14159265358979323846;
}

}  // namespace relume
