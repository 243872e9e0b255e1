// lit_sphere: some samples a pixel through the kernel that shades frames, then their mean.
#include "lab/lit_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gbuffer/error.h"
#include "gbuffer/gbuffer.h"
#include "host/binding.h"
#include "host/light_records.h"

namespace relume {
namespace {

constexpr int samples = 4;  // along each side of a pixel: sixteen shades of an edge

GBuffer unit_sphere(int side, int spare_planes) {
  const std::size_t pixels = std::size_t(side) * std::size_t(side);
  GBuffer g{{0, 0, side, side}, Planes(pixels, 7 + spare_planes), {}, {}, {}, {}, false, {}, {}, 0, 0};
  g.position = {g.planes.add(3), 3};
  g.normal = {g.planes.add(3), 3};
  g.coverage = {g.planes.add(), 1};
  std::size_t i = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column, ++i) {
      constexpr double margin = 0.96;  // the sphere's radius in half a side
      const double x = (2 * (column + 0.5) / side - 1) / margin, y = (1 - 2 * (row + 0.5) / side) / margin, z2 = 1 - x * x - y * y;
      if (z2 <= 0) continue;
      const double place[] = {x, y, std::sqrt(z2)};
      for (int c = 0; c < 3; ++c) g.planes.plane(c)[i] = g.planes.plane(3 + c)[i] = float(place[c]);
      g.planes.plane(g.coverage.first)[i] = 1;
      ++g.surface_pixels;
    }
  return g;
}

Frame frame_of(const GBuffer& g, const LightRecords& lights) {
  Frame frame{};
  frame.pixels = int(g.samples());
  frame.plane_stride = int(g.planes.stride());
  frame.position = g.position.first;
  frame.normal = g.normal.first;
  frame.base_normal = frame.diffuse = frame.specular = frame.ambient_out = -1;
  frame.viewer[2] = 1;  // orthographic, from +z
  std::copy(lights.begin.begin(), lights.begin.end(), frame.light_begin);
  return frame;
}

LightRecords light_from(const glm::dvec3& to_light) {
  Light light;
  light.type = LightType::directional;
  light.direction = -to_light;
  light.intensity = glm::dvec3(std::numbers::pi);
  return light_records({light});
}

/// Means of blocks of samples.
Picture pixels_of(const GBuffer& g, const Planes& out, int size) {
  Picture picture{size, size, 4, std::vector<float>(std::size_t(size) * std::size_t(size) * 4)};
  const std::size_t side = std::size_t(size) * samples;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const std::size_t i = y * side + x;
      float* const pixel = picture.values.data() + (y / samples * std::size_t(size) + x / samples) * 4;
      const float share = g.planes.plane(g.coverage.first)[i] / (samples * samples);
      for (int c = 0; c < 3; ++c) pixel[c] += share * out.plane(c)[i];
      pixel[3] += share;
    }
  return picture;
}

}  // namespace

Picture lit_sphere(const Material& material, const SphereView& view, Device& device) {
  Reading reading;
  const LayerFinder no_layers = [](const std::string&) -> RoleLayer { throw Error(ErrorKind::input, "--set: a lit sphere takes constants"); };
  const Binding binding(material, std::nullopt, "sphere", no_layers, reading);
  GBuffer g = unit_sphere(view.size * samples, binding.spare_planes());
  const LightRecords lights = light_from(view.to_light);
  Frame frame = frame_of(g, lights);
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  binding.bind(g, camera, frame);
  Planes out(g.planes.pixels(), 3);
  out.add(3);
  frame.out_stride = int(out.stride());
  const auto band = device.bind({&g.planes, lights.records, {}, binding.tables(), &out});
  band->shade(binding.programs().front(), frame, {});
  band->finish();
  return pixels_of(g, out, view.size);
}

}  // namespace relume
