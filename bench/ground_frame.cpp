// Ground y = h(x, z) over -10..10, its normals within 25 degrees of up; lights 15 to 30 above it and within 8 of its middle, so that none is lower
// than 25 degrees over any pixel's tangent plane.
#include "bench/ground_frame.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>

namespace relume::bench {
namespace {

constexpr double half_side = 10;  // world units

struct Ground {
  double height, slope_x, slope_z;
};

/// Slopes of at most 0.1 + 0.3 in all: 22 degrees.
Ground ground_at(double x, double z) { return {0.1 * std::sin(x) + 0.1 * std::sin(3 * z), 0.1 * std::cos(x), 0.3 * std::cos(3 * z)}; }

/// A role's value where the gloss, 0..1, varies over the ground.
std::array<double, 3> value_of(const std::string& role, double gloss) {
  const double alpha = 0.8 - 0.7 * gloss;
  if (role == "alpha") return {alpha};
  if (role == "roughness") return {std::sqrt(alpha)};
  if (role == "exponent") return {8 + 100 * gloss};
  if (role == "ks") return {0.3, 0.3 + 0.1 * gloss, 0.4};
  return {0.3 + 0.4 * gloss, 0.5, 0.6 - 0.3 * gloss};  // colours of the surface
}

void fill_row(GBuffer& frame, int y) {
  const int width = frame.window.width(), height = frame.window.height();
  for (int x = 0; x < width; ++x) {
    const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
    const double px = half_side * (2 * (x + 0.5) / width - 1), pz = half_side * (2 * (y + 0.5) / height - 1);
    const Ground g = ground_at(px, pz);
    const double length = std::sqrt(g.slope_x * g.slope_x + 1 + g.slope_z * g.slope_z);
    const auto put = [&](PlaneRange range, const std::array<double, 3>& values) {
      for (int c = 0; c < range.count; ++c) frame.planes.plane(range.first + c)[i] = float(values[std::size_t(c)]);
    };
    put(frame.position, {px, g.height, pz});
    put(frame.normal, {-g.slope_x / length, 1 / length, -g.slope_z / length});
    put(frame.coverage, {1});
    for (const auto& [role, range] : frame.roles) put(range, value_of(role, 0.5 + 0.5 * std::sin(0.7 * px + 1.3 * pz)));
  }
}

const std::map<std::string, int> components{{"albedo", 3}, {"kd", 3},    {"base_color", 3}, {"glossy_albedo", 3},
                                            {"ks", 3},     {"alpha", 1}, {"roughness", 1},  {"exponent", 1}};

GBuffer ground_frame(int width, int height, const std::vector<std::string>& roles, int spare_planes) {
  constexpr int geometry = 7;  // position, normal, coverage
  const int planes = geometry + 3 * int(roles.size()) + spare_planes;
  GBuffer frame{{0, 0, width, height}, Planes(std::size_t(width) * std::size_t(height), planes), {}, {}, {}, {}, false, {}, {}};
  const auto add = [&](int count) { return PlaneRange{frame.planes.add(count), count}; };
  frame.position = add(3);
  frame.normal = add(3);
  frame.coverage = add(1);
  for (const std::string& role : roles) frame.roles[role] = add(components.at(role));
  frame.surface_pixels = frame.window.pixels();
  tbb::parallel_for(0, height, [&](int y) { fill_row(frame, y); });
  return frame;
}

}  // namespace

FrameSource ground_source(int width, int height) {
  FrameSource source;
  for (const auto& [role, count] : components) source.roles.push_back(role);
  source.camera.world_from_camera = {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 25, 0, 1}};  // right, up, backward, eye
  source.camera.source = "made in memory";
  source.make = [=](const std::vector<std::string>& roles, int spare_planes) { return ground_frame(width, height, roles, spare_planes); };
  return source;
}

std::vector<Light> ground_lights(LightType type, int count) {
  std::mt19937 random(5);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  std::vector<Light> lights;
  for (int k = 0; k < count; ++k) {
    Light light;
    light.type = type;
    light.position = {in(-8, 8), in(15, 30), in(-8, 8)};
    light.direction = type == LightType::spot ? glm::dvec3(0, -1, 0) : glm::normalize(glm::dvec3(in(-0.5, 0.5), -1, in(-0.5, 0.5)));
    light.intensity = glm::dvec3(in(50, 150), in(50, 150), in(50, 150)) / double(count);
    light.inner_angle = 20;
    light.outer_angle = 70;
    lights.push_back(light);
  }
  return lights;
}

}  // namespace relume::bench
