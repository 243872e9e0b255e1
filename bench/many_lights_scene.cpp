// Traced in single precision: the numbers are to be those that the workload's other spellings hold.
#include "bench/many_lights_scene.h"

#include <half.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <random>

namespace relume::bench {
namespace {

using glm::vec3;

constexpr float pi = 3.14159265f, turn = 6.2831853f, near_plane = 0.5f, far_plane = 300;
const vec3 eye{0, 12, -70};  // looks along +z, 10 degrees down, in a left-handed world; z is turned on output

struct Ball {
  vec3 centre;
  float radius;
};

struct Post {
  float x, z, radius, height;
};

struct Hit {
  float t = 1e30f;
  vec3 normal{0}, albedo{0};
  float specular = 0, exponent = 8;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }

 private:
  std::mt19937 engine_;
};

/// A point in the disc that everything stands on.
vec3 somewhere(Random& random) {
  const float radius = std::sqrt(random(0, 1)) * 100, angle = random(0, turn);
  return {radius * std::cos(angle), 0, radius * std::sin(angle)};
}

vec3 unit(const vec3& a) { return a * (1 / std::sqrt(glm::dot(a, a))); }

struct Scene {
  std::vector<Ball> balls;
  std::vector<Post> posts;

  explicit Scene(Random& random) {
    for (int i = 0; i < 220; ++i) {
      const vec3 place = somewhere(random);
      const float radius = random(0.8f, 3.5f), low = random(0, 1), up = random(2, 16);
      balls.push_back({{place.x, low < 0.6f ? radius : up, place.z}, radius});
    }
    for (int i = 0; i < 60; ++i) {
      const vec3 place = somewhere(random);
      const float radius = random(0.6f, 2), height = random(8, 30);
      posts.push_back({place.x, place.z, radius, height});
    }
  }

  Hit trace(const vec3& d) const {
    Hit hit;
    ground(d, hit);
    wall(d, hit);
    for (unsigned k = 0; k < balls.size(); ++k) ball(d, k, hit);
    for (const Post& p : posts) post(d, p, hit);
    return hit;
  }

 private:
  static void ground(const vec3& d, Hit& hit) {
    if (!(d.y < 0)) return;
    const float t = -eye.y / d.y;
    const vec3 p = eye + d * t;
    if (!(t > near_plane && t < far_plane)) return;
    const float bump = 0.15f * std::sin(p.x * 1.7f) + 0.1f * std::sin(p.z * 2.3f + p.x);
    const bool odd = (int(std::floor(p.x / 4)) + int(std::floor(p.z / 4))) & 1;
    hit = {t, unit({bump * 0.4f, 1, 0.15f * std::sin(p.z * 1.1f)}), odd ? vec3(.59f, .55f, .47f) : vec3(.35f, .37f, .39f), .3f, 20};
  }

  static void wall(const vec3& d, Hit& hit) {
    const float t = (60 - eye.z) / d.z;
    const vec3 p = eye + d * t;
    if (t < hit.t && t > near_plane && p.y >= 0 && p.y < 45) hit = {t, {0, 0, -1}, {.47f, .43f, .41f}, .1f, 10};
  }

  void ball(const vec3& d, unsigned k, Hit& hit) const {
    const Ball& ball = balls[k];
    const vec3 o = eye - ball.centre;
    const float a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - ball.radius * ball.radius, discriminant = b * b - a * c;
    if (discriminant <= 0) return;
    const float t = (-b - std::sqrt(discriminant)) / a;
    const auto colour = [&](unsigned step) { return float(80 + k * step % 160) / 255.f; };
    if (t > near_plane && t < hit.t) hit = {t, unit(eye + d * t - ball.centre), {colour(37), colour(59), colour(83)}, .8f, float(16 + k * 13 % 100)};
  }

  static void post(const vec3& d, const Post& post, Hit& hit) {
    const float ox = eye.x - post.x, oz = eye.z - post.z, a = d.x * d.x + d.z * d.z, b = ox * d.x + oz * d.z,
                discriminant = b * b - a * (ox * ox + oz * oz - post.radius * post.radius);
    if (discriminant <= 0) return;
    const float t = (-b - std::sqrt(discriminant)) / a;
    const vec3 p = eye + d * t;
    if (t > near_plane && t < hit.t && p.y > 0 && p.y < post.height) hit = {t, unit({p.x - post.x, 0, p.z - post.z}), {.67f, .63f, .55f}, .5f, 32};
  }
};

vec3 turned(const vec3& v) { return {v.x, v.y, -v.z}; }

/// Both spellings hold colours as half floats.
float as_half(float x) { return half(x); }

/// The model's Kd + Ks (n.h)^e, with Ks = albedo specular (e+2)/8, in the terms of lambert_original and blinn_phong: f_r n.l = ks (e+2)/(2 pi) ....
void store(GBuffer& frame, std::size_t i, const vec3& position, const Hit& hit) {
  const auto put = [&](PlaneRange range, int c, float value) {
    if (c < range.count) frame.planes.plane(range.first + c)[i] = value;
  };
  for (int c = 0; c < 3; ++c) {
    const float albedo = std::round(hit.albedo[c] * 255) / 255, ks = as_half(albedo * hit.specular * (hit.exponent + 2) / 8);
    put(frame.position, c, position[c]);
    put(frame.normal, c, turned(hit.normal)[c]);
    put(frame.roles["kd"], c, as_half(albedo));
    put(frame.roles["ks"], c, ks * (2 * std::numbers::pi_v<float> / (hit.exponent + 2)));
  }
  put(frame.roles["exponent"], 0, hit.exponent);
  put(frame.coverage, 0, 1);
}

GBuffer traced(const Scene& scene, int width, int height, const std::vector<std::string>& roles, int spare_planes) {
  GBuffer frame{{0, 0, width, height}, Planes(std::size_t(width) * std::size_t(height), 14 + spare_planes), {}, {}, {}, {}, false, {}, {}};
  const auto add = [&](int count) { return PlaneRange{frame.planes.add(count), count}; };
  frame.position = add(3);
  frame.normal = add(3);
  frame.coverage = add(1);
  for (const std::string& role : roles) frame.roles[role] = add(role == "exponent" ? 1 : 3);
  for (const char* role : {"kd", "ks", "exponent"}) frame.roles.try_emplace(role, PlaneRange{-1, 0});
  const float scale_y = 1 / std::tan(30 * pi / 180), scale_x = scale_y * float(height) / float(width);
  const float cosine = std::cos(10 * pi / 180), sine = std::sin(10 * pi / 180);
  std::vector<std::int64_t> seen(static_cast<std::size_t>(height));
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const vec3 d{((float(x) + .5f) * 2 / float(width) - 1) / scale_x, -((float(y) + .5f) * 2 / float(height) - 1) / scale_y, 1};
      const vec3 world{d.x, d.y * cosine - d.z * sine, d.y * sine + d.z * cosine};
      const Hit hit = scene.trace(world);
      if (hit.t >= far_plane) continue;
      store(frame, std::size_t(y) * std::size_t(width) + std::size_t(x), turned(eye + world * hit.t), hit);
      ++seen[std::size_t(y)];
    }
  });
  for (const std::int64_t row : seen) frame.surface_pixels += row;
  return frame;
}

float share(float x) { return std::clamp(x, 0.f, 1.f); }

Light ranged_light(Random& random, double reach) {
  const vec3 place = somewhere(random);
  const float up = random(0.3f, 20), low = random(0.2f, 1), range = random(2, 15) * float(reach), strength = random(0.1f, 0.5f), hue = random(0, 6);
  Light light;
  light.position = turned({place.x, up * low, place.z});
  light.intensity =
      glm::dvec3(share(std::fabs(hue - 3) - 1) * strength, share(2 - std::fabs(hue - 2)) * strength, share(2 - std::fabs(hue - 4)) * strength);
  light.falloff = Falloff::linear;
  light.range_begin = 0.8f * range;
  light.range = range;
  return light;
}

}  // namespace

ManyLights many_lights(int width, int height, double reach, unsigned seed, int lights) {
  Random random(seed);
  const auto scene = std::make_shared<Scene>(random);
  ManyLights made;
  for (int k = 0; k < lights; ++k) made.lights.push_back(ranged_light(random, reach));
  made.source.roles = {"kd", "ks", "exponent"};
  const glm::dvec3 viewer = turned(eye);
  made.source.camera.world_from_camera[3] = glm::dvec4(viewer, 1);
  made.source.make = [=](const std::vector<std::string>& roles, int spare) { return traced(*scene, width, height, roles, spare); };
  return made;
}

}  // namespace relume::bench
