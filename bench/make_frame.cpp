// Makes a G-buffer for benchmarks: spheres over a plane, 13 half channels (N, P, albedo, roughness, metallic, u, v), ZIP, with a camera in the rig
// beside it.
//
//   make_frame WIDTH HEIGHT LIGHTS STEM      writes STEM.exr and STEM.rig.json
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <half.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

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

Hit trace(const dvec3& d, const std::vector<Sphere>& all) {
  Hit hit;
  if (d.y < 0) {
    hit.t = -eye.y / d.y;
    const dvec3 p = eye + d * hit.t;
    hit.n = {0, 1, 0};
    hit.albedo = (int(std::floor(p.x)) + int(std::floor(p.z))) & 1 ? dvec3(0.7, 0.65, 0.6) : dvec3(0.2, 0.25, 0.3);
    hit.roughness = 0.4;
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const dvec3 o = eye - all[k].centre;
    const double a = glm::dot(d, d), b = glm::dot(o, d), disc = b * b - a * (glm::dot(o, o) - all[k].radius * all[k].radius);
    if (disc <= 0) continue;
    const double t = (-b - std::sqrt(disc)) / a;
    if (t <= 0 || t >= hit.t) continue;
    hit.t = t;
    hit.n = glm::normalize(eye + d * t - all[k].centre);
    hit.albedo = {0.3 + 0.6 * double(k % 3) / 2, 0.3 + 0.6 * double(k % 5) / 4, 0.3 + 0.6 * double(k % 7) / 6};
    hit.roughness = 0.1 + 0.8 * double(k % 11) / 10;
    hit.metallic = double(k % 2);
  }
  return hit;
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
  const int width = std::atoi(argv[1]), height = std::atoi(argv[2]);
  const std::string stem = argv[4];
  const std::array names{"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "u", "v"};
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  std::vector<half> planes(names.size() * pixels);
  const std::vector<Sphere> all = spheres();
  const double scale = 2 * std::tan(fov * M_PI / 360) / height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const dvec3 d{(x + 0.5 - width / 2.0) * scale, (height / 2.0 - y - 0.5) * scale, -1};
      const Hit hit = trace(d, all);
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
      for (std::size_t c = 0; c < names.size(); ++c)
        planes[c * pixels + std::size_t(y) * std::size_t(width) + std::size_t(x)] = half(float(values[c]));
    }
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::HALF));
    frame.insert(names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&planes[c * pixels]), sizeof(half), sizeof(half) * std::size_t(width)));
  }
  Imf::OutputFile out((stem + ".exr").c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(height);
  write_rig(stem + ".rig.json", std::atoi(argv[3]));
}
