// Made-up G-buffers for tests of the whole program: a sphere over a floor, of any size, window, sample type and set of channels, hostile values
// on request; written in bands, so that a frame larger than memory can be made.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <thread>
#include <vector>

#include "gbuffer/window.h"

namespace relume {

/// What a pixel of the made-up scene shows; tests may change it before it is written.
struct ScenePixel {
  int id = 0;  ///< 1 the sphere, 2 the floor, 0 background
  glm::dvec3 position{0}, normal{0}, albedo{0};
  double roughness = 0, metallic = 0, alpha = 0;
};

struct MadeUpGBuffer {
  Window data{0, 0, 64, 64}, display{0, 0, 64, 64};
  bool half = false, floor = true;
  bool camera_in_header = true;
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  /// P, N and albedo have three components; roughness, metallic, A and id (whole numbers) one; any other channel is 0.5.
  std::vector<std::string> channels{"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"};
  std::function<void(int x, int y, ScenePixel&)> pixel;
  std::function<void(Imf::Header&)> header;

  static MadeUpGBuffer of_size(int width, int height) {
    MadeUpGBuffer made;
    made.data = made.display = {0, 0, width, height};
    return made;
  }
  void with(std::initializer_list<const char*> more) { channels.insert(channels.end(), more.begin(), more.end()); }
};

/// The eye that sees the scene; the camera looks along -z with y up.
inline constexpr double scene_eye_z = 5;

/// As the JSON of a rig's "camera".
inline const char* const scene_camera_json = R"({"world_from_camera": [1,0,0,0, 0,1,0,0, 0,0,1,5, 0,0,0,1], "vertical_fov": 40})";

/// The sphere has radius 1 around the origin; the floor lies at y = -1, as far as z = -20. The longer side of the display window spans 40 degrees.
inline ScenePixel scene_at(const MadeUpGBuffer& made, int x, int y) {
  const Window& d = made.display;
  const double scale = 2 * std::tan(20 * 3.14159265358979323846 / 180) / std::max(d.width(), d.height());
  const glm::dvec3 eye{0, 0, scene_eye_z}, ray{(x + 0.5 - 0.5 * (d.min_x + d.max_x)) * scale, -(y + 0.5 - 0.5 * (d.min_y + d.max_y)) * scale, -1};
  ScenePixel pixel;
  const double a = glm::dot(ray, ray), b = glm::dot(eye, ray), c = glm::dot(eye, eye) - 1, root = b * b - a * c;
  if (root >= 0) {
    pixel.id = 1;
    pixel.position = pixel.normal = eye + ray * ((-b - std::sqrt(root)) / a);
    pixel.albedo = {0.8, 0.4, 0.2};
    pixel.roughness = 0.4;
    pixel.metallic = pixel.position.x > 0 ? 1 : 0;
  } else if (made.floor && ray.y < 0 && -1 / ray.y < 25) {
    pixel.id = 2;
    pixel.position = eye + ray * (-1 / ray.y);
    pixel.normal = {0, 1, 0};
    const bool dark = (int(std::floor(pixel.position.x)) + int(std::floor(pixel.position.z))) % 2 != 0;
    pixel.albedo = dark ? glm::dvec3(0.3, 0.3, 0.4) : glm::dvec3(0.7, 0.7, 0.6);
    pixel.roughness = 0.7;
  }
  pixel.alpha = pixel.id != 0;
  return pixel;
}

namespace scene {

using Reader = std::function<float(const ScenePixel&)>;

/// What a channel holds of a pixel.
inline Reader reader_of(const std::string& channel) {
  const int xyz = int(std::string("XYZ").find(channel.back())), rgb = int(std::string("RGB").find(channel.back()));
  if (channel.starts_with("P.")) return [=](const ScenePixel& pixel) { return float(pixel.position[xyz]); };
  if (channel.starts_with("N.")) return [=](const ScenePixel& pixel) { return float(pixel.normal[xyz]); };
  if (channel.starts_with("albedo.")) return [=](const ScenePixel& pixel) { return float(pixel.albedo[rgb]); };
  if (channel == "roughness") return [](const ScenePixel& pixel) { return float(pixel.roughness); };
  if (channel == "metallic") return [](const ScenePixel& pixel) { return float(pixel.metallic); };
  if (channel == "A") return [](const ScenePixel& pixel) { return float(pixel.alpha); };
  return [](const ScenePixel&) { return 0.5f; };
}

inline Imf::Header header_of(const MadeUpGBuffer& made) {
  const Window &w = made.data, &d = made.display;
  Imf::Header header({{d.min_x, d.min_y}, {d.max_x - 1, d.max_y - 1}}, {{w.min_x, w.min_y}, {w.max_x - 1, w.max_y - 1}});
  header.compression() = made.compression;
  for (const std::string& channel : made.channels)
    header.channels().insert(channel, Imf::Channel(channel == "id" ? Imf::UINT : made.half ? Imf::HALF : Imf::FLOAT));
  // For row vectors, and a camera that looks along +z: that is how OpenEXR's attribute is meant.
  if (made.camera_in_header) header.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, float(scene_eye_z), 1}));
  if (made.header) made.header(header);
  return header;
}

}  // namespace scene

inline void write_gbuffer(const std::filesystem::path& file, const MadeUpGBuffer& made) {
  Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency()));
  Imf::OutputFile out(file.c_str(), scene::header_of(made));
  const int width = made.data.width();
  const int rows = std::clamp(int((1 << 20) / std::max(width, 1)), 1, 256);  // a band of a million pixels at most
  std::vector<std::vector<float>> planes(made.channels.size(), std::vector<float>(std::size_t(width) * std::size_t(rows)));
  std::vector<std::vector<half>> halves(made.half ? planes.size() : 0, std::vector<half>(planes[0].size()));
  std::vector<scene::Reader> readers;
  for (const std::string& channel : made.channels) readers.push_back(scene::reader_of(channel));
  std::vector<unsigned> ids(planes[0].size());
  for (int y = made.data.min_y; y < made.data.max_y; y += rows) {
    const int count = std::min(rows, made.data.max_y - y);
    for (std::size_t i = 0; i < std::size_t(width) * std::size_t(count); ++i) {
      const int px = made.data.min_x + int(i) % width, py = y + int(i) / width;
      ScenePixel pixel = scene_at(made, px, py);
      if (made.pixel) made.pixel(px, py, pixel);
      ids[i] = unsigned(pixel.id);
      for (std::size_t c = 0; c < planes.size(); ++c) {
        planes[c][i] = readers[c](pixel);
        if (made.half) halves[c][i] = ::half(planes[c][i]);
      }
    }
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < planes.size(); ++c) {
      const bool is_id = made.channels[c] == "id";
      const Imf::PixelType type = is_id ? Imf::UINT : made.half ? Imf::HALF : Imf::FLOAT;
      void* const first = is_id       ? static_cast<void*>(ids.data())
                          : made.half ? static_cast<void*>(halves[c].data())
                                      : static_cast<void*>(planes[c].data());
      frame.insert(made.channels[c], Imf::Slice::Make(type, first, {made.data.min_x, y}, width, count));
    }
    out.setFrameBuffer(frame);
    out.writePixels(count);
  }
}

}  // namespace relume
