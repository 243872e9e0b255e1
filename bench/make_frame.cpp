// Makes a G-buffer for benchmarks: spheres over a plane, 13 half channels (N, P, albedo, roughness, metallic, u, v), ZIP, with a camera in the rig
// beside it. Written band by band, so that it may be larger than memory.
//
//   make_frame WIDTH HEIGHT LIGHTS STEM      writes STEM.exr and STEM.rig.json
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "gbuffer/write_exr.h"

namespace {

using glm::dvec3;

struct Hit {
  double t = 1e30;
  dvec3 n{0}, albedo{0};
  double roughness = 0, metallic = 0;
};

struct Sphere {
  dvec3 centre;
  double radius;
};

const dvec3 eye{0, 2, 9};
constexpr double fov = 45;  // degrees, vertical

std::vector<Sphere> spheres() {
  std::mt19937 random(7);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  std::vector<Sphere> all;
  for (int i = 0; i < 60; ++i) {
    const double radius = in(0.2, 0.7);
    all.push_back({{in(-6, 6), radius, in(-8, 4)}, radius});
  }
  return all;
}

/// The angles between which a sphere is seen: a row, or a stretch of it, asks only those that it meets.
bool may_meet(const Sphere& sphere, const dvec3& a, const dvec3& b) {
  const dvec3 o = sphere.centre - eye, middle = glm::normalize(glm::normalize(a) + glm::normalize(b));
  const double stretch = std::acos(glm::clamp(glm::dot(glm::normalize(a), middle), -1.0, 1.0)), size = std::asin(sphere.radius / glm::length(o));
  return std::acos(glm::clamp(glm::dot(glm::normalize(o), middle), -1.0, 1.0)) <= stretch + size;
}

Hit trace(const dvec3& d, const std::vector<std::pair<std::size_t, Sphere>>& near) {
  Hit hit;
  if (d.y < 0) {
    hit.t = -eye.y / d.y;
    const dvec3 p = eye + d * hit.t;
    hit.n = {0, 1, 0};
    hit.albedo = (int(std::floor(p.x)) + int(std::floor(p.z))) & 1 ? dvec3(0.7, 0.65, 0.6) : dvec3(0.2, 0.25, 0.3);
    hit.roughness = 0.4;
  }
  for (const auto& [k, sphere] : near) {
    const dvec3 o = eye - sphere.centre;
    const double a = glm::dot(d, d), b = glm::dot(o, d), disc = b * b - a * (glm::dot(o, o) - sphere.radius * sphere.radius);
    if (disc <= 0) continue;
    const double t = (-b - std::sqrt(disc)) / a;
    if (t <= 0 || t >= hit.t) continue;
    hit.t = t;
    hit.n = glm::normalize(eye + d * t - sphere.centre);
    hit.albedo = {0.3 + 0.6 * double(k % 3) / 2, 0.3 + 0.6 * double(k % 5) / 4, 0.3 + 0.6 * double(k % 7) / 6};
    hit.roughness = 0.1 + 0.8 * double(k % 11) / 10;
    hit.metallic = double(k % 2);
  }
  return hit;
}

struct View {
  int width, height;
  dvec3 direction(double x, double y) const {
    const double scale = 2 * std::tan(fov * M_PI / 360) / height;
    return {(x + 0.5 - width / 2.0) * scale, (height / 2.0 - y - 0.5) * scale, -1};
  }
};

const std::vector<std::string> names{"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "u", "v"};

/// One row, a plane of `stride` floats for each channel.
void render_row(const View& view, int y, const std::vector<Sphere>& all, float* row, std::size_t stride) {
  constexpr int stretch = 64;
  std::vector<std::pair<std::size_t, Sphere>> near;
  for (int x = 0; x < view.width; ++x) {
    if (x % stretch == 0) {
      near.clear();
      for (std::size_t k = 0; k < all.size(); ++k)
        if (may_meet(all[k], view.direction(x, y), view.direction(x + stretch, y))) near.emplace_back(k, all[k]);
    }
    const dvec3 d = view.direction(x, y);
    const Hit hit = trace(d, near);
    if (hit.t > 60) continue;
    const dvec3 p = eye + d * hit.t;
    const double values[] = {hit.n.x,
                             hit.n.y,
                             hit.n.z,
                             p.x,
                             p.y,
                             p.z,
                             hit.albedo.x,
                             hit.albedo.y,
                             hit.albedo.z,
                             hit.roughness,
                             hit.metallic,
                             p.x - std::floor(p.x),
                             p.z - std::floor(p.z)};
    for (std::size_t c = 0; c < names.size(); ++c) row[c * stride + std::size_t(x)] = float(values[c]);
  }
}

void write_frame(const std::string& file, const View& view) {
  const relume::Window window{0, 0, view.width, view.height};
  relume::ExrWriter writer(file, {relume::SampleType::half_float, "zip", true}, {}, window, window, names, {});
  const std::vector<Sphere> all = spheres();
  constexpr int band_rows = 64;
  const std::size_t width = std::size_t(view.width), stride = width * band_rows;
  for (int top = 0; top < view.height; top += band_rows) {
    const int rows = std::min(band_rows, view.height - top);
    std::vector<float> planes(names.size() * stride);
    tbb::parallel_for(0, rows, [&](int y) { render_row(view, top + y, all, planes.data() + std::size_t(y) * width, stride); });
    std::vector<relume::Source> sources;
    for (std::size_t c = 0; c < names.size(); ++c) sources.push_back({names[c], planes.data() + c * stride, sizeof(float), sizeof(float) * width});
    writer.write_rows(rows, sources);
  }
  writer.commit();
}

void write_rig(const std::string& file, int lights) {
  std::mt19937 random(11);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  std::ofstream rig(file);
  rig << "{\"relume\": 1,\n \"camera\": {\"world_from_camera\": [1,0,0," << eye.x << ", 0,1,0," << eye.y << ", 0,0,1," << eye.z
      << ", 0,0,0,1], \"vertical_fov\": " << fov << "},\n \"lights\": [";
  for (int k = 0; k < lights; ++k)
    rig << (k ? "," : "") << "\n  {\"type\": \"point\", \"position\": [" << in(-6, 6) << ", " << in(1, 6) << ", " << in(-6, 6)
        << "], \"intensity\": [" << in(2, 20) / lights << ", " << in(2, 20) / lights << ", " << in(2, 20) / lights << "]}";
  rig << "\n]}\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::fprintf(stderr, "usage: make_frame WIDTH HEIGHT LIGHTS STEM\n"), 2;
  const std::string stem = argv[4];
  write_frame(stem + ".exr", {std::atoi(argv[1]), std::atoi(argv[2])});
  write_rig(stem + ".rig.json", std::atoi(argv[3]));
}
