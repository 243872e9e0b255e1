// What becomes of each pixel.
#include "gbuffer/finisher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/cryptomatte.h"

namespace relume {

using glm::dvec3;

Finisher::Finisher(GBuffer& g, const Reading& reading, const LooseLayers& loose)
    : g_(g),
      reading_(reading),
      frame_(reading),
      loose_(loose),
      tangent_ids_(reading.tangent_ids.begin(), reading.tangent_ids.end()),
      bumped_ids_(reading.bumped_ids.begin(), reading.bumped_ids.end()) {}

std::vector<Finisher::RolePlane> Finisher::role_planes() const {
  std::vector<RolePlane> all;
  for (const auto& [role, range] : g_.roles)
    for (int c = 0; c < range.count && role != "coverage" && !role.starts_with(cryptomatte_role); ++c)
      all.push_back({g_.planes.plane(range.first + c), role == "albedo" && made_albedo_});
  return all;
}

Finisher::Count Finisher::finish(std::size_t begin, std::size_t end) const {
  Count count;
  std::array<double, 512> factors;  // of as many pixels at a time as stay in the nearest cache, plane by plane
  for (std::size_t first = begin; first < end; first += factors.size()) {
    const std::size_t pixels = std::min(factors.size(), end - first);
    for (std::size_t k = 0; k < pixels; ++k) factors[k] = finish_pixel(first + k, count);
    for (const RolePlane& plane : role_planes_)
      for (std::size_t k = 0; k < pixels; ++k) {
        const float value = plane.values[first + k];
        const double factor = plane.quotient ? std::min(factors[k], 1.0) : factors[k];
        plane.values[first + k] = std::isfinite(value) ? float(value * factor) : 0;
      }
  }
  return count;
}

dvec3 Finisher::get(const PlaneRange& range, std::size_t i) const {
  return {g_.planes.plane(range.first)[i], g_.planes.plane(range.first + 1)[i], g_.planes.plane(range.first + 2)[i]};
}

void Finisher::put(const PlaneRange& range, std::size_t i, const dvec3& v) const {
  for (int c = 0; c < 3; ++c) g_.planes.plane(range.first + c)[i] = float(v[c]);
}

bool Finisher::finite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool Finisher::concerns(const std::set<std::uint32_t>& ids, std::size_t i) const {
  return ids.empty() || (!loose_.ids.empty() && ids.contains(loose_.ids[i]));
}

dvec3 Finisher::unit_in_world(const dvec3& decoded, const dvec3& position) const {
  constexpr double no_direction = 1e-6;  // less than the smallest half float is rounding, or a filter's tail
  const double length = glm::length(decoded);
  if (!(length > no_direction)) return dvec3(0);
  const dvec3 n = frame_.direction_in_world(decoded / length, position);
  return glm::length(n) > no_direction ? n / glm::length(n) : dvec3(0);  // V-Ray's frame has none straight up
}

dvec3 Finisher::position_at(std::size_t i, double coverage) const {
  const double share = reading_.position_premultiplied ? coverage : 1;
  if (!made_positions_) return frame_.position_in_world(get(g_.position, i) / share);
  const Window& w = g_.window;
  const int x = w.min_x + int(i % std::size_t(w.width())), y = w.min_y + int(i / std::size_t(w.width()));
  return frame_.position_from_depth(x, y, loose_.depth[i] / share);
}

bool Finisher::in_background(std::size_t i) const {
  if (loose_.depth.empty()) return false;
  const float depth = std::abs(loose_.depth[i]);
  return !(depth < reading_.background_depth) || (made_positions_ && depth == 0);
}

double Finisher::finish_pixel(std::size_t i, Count& count) const {
  const double coverage = loose_.coverage.empty() ? 1 : loose_.coverage[i];
  const dvec3 stored = frame_.decoded(get(g_.normal, i));
  const bool far = in_background(i);
  const dvec3 position = far || !(coverage > 0) ? get(g_.position, i) : position_at(i, coverage);
  const bool bad = !finite(stored) || !finite(position);
  count.bad += bad;
  const dvec3 normal = bad || far ? dvec3(0) : unit_in_world(stored, position);
  if (normal == dvec3(0) || !(coverage > 0)) return finish_empty(i);
  put(g_.position, i, position);
  finish_normals(i, normal, position);
  g_.planes.plane(g_.coverage.first)[i] = float(coverage);
  ++count.surface;
  count.partial += coverage < 1;
  return reading_.position_premultiplied ? 1 / coverage : 1;
}

void Finisher::finish_normals(std::size_t i, const dvec3& normal, const dvec3& position) const {
  const dvec3 base = g_.base_normal.count ? unit_in_world(frame_.decoded(get(g_.base_normal, i)), position) : dvec3(0);
  const bool usable = finite(base) && base != dvec3(0);
  dvec3 shading = normal;
  if (usable && !loose_.tangent.empty() && concerns(tangent_ids_, i)) shading = from_tangent_frame(normal, base, i);
  put(g_.normal, i, shading);
  if (g_.base_normal.count) put(g_.base_normal, i, usable && concerns(bumped_ids_, i) ? base : shading);
}

dvec3 Finisher::from_tangent_frame(const dvec3& local, const dvec3& n, std::size_t i) const {
  const dvec3 dp_du{loose_.tangent[3 * i], loose_.tangent[3 * i + 1], loose_.tangent[3 * i + 2]}, along = dp_du - n * glm::dot(n, dp_du);
  if (!(glm::length(along) > 0)) return n;
  const dvec3 s = glm::normalize(along);
  return glm::normalize(s * local.x + glm::cross(n, s) * local.y + n * local.z);
}

double Finisher::finish_empty(std::size_t i) const {
  put(g_.position, i, dvec3(0));
  put(g_.normal, i, dvec3(0));
  if (g_.base_normal.count) put(g_.base_normal, i, dvec3(0));
  g_.planes.plane(g_.coverage.first)[i] = 0;
  return 0;
}

}  // namespace relume
