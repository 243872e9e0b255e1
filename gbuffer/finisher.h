// From pixels as a file stores them to what GBuffer promises.
#pragma once

#include <glm/vec3.hpp>
#include <set>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "gbuffer/layer_frame.h"

namespace relume {

/// Layers that are read but not kept.
struct LooseLayers {
  std::vector<float> depth, tangent, raw_light;
  std::vector<float> float_ids, coverage;
  std::vector<std::uint32_t> ids;
};

/// Turns one pixel after another plain: world space, unit normals, values divided by their coverage, nothing where there is no surface.
class Finisher {
 public:
  struct Count {
    std::int64_t surface = 0, bad = 0, partial = 0;
  };

  /// All three outlive it.
  Finisher(GBuffer& g, const Reading& reading, const LooseLayers& loose);

  /// Pixels begin to end; different ones may be finished at once.
  Count finish(std::size_t begin, std::size_t end) const;

 private:
  glm::dvec3 get(const PlaneRange& range, std::size_t i) const;
  void put(const PlaneRange& range, std::size_t i, const glm::dvec3& v) const;
  static bool finite(const glm::dvec3& v);
  bool concerns(const std::set<std::uint32_t>& ids, std::size_t i) const;
  glm::dvec3 unit_in_world(const glm::dvec3& decoded, const glm::dvec3& position) const;
  /// World; infinite where a depth says that nothing is there.
  glm::dvec3 position_at(std::size_t i, double coverage) const;
  bool in_background(std::size_t i) const;
  /// What the other roles are multiplied by: 0 where there is no surface.
  double finish_pixel(std::size_t i, Count& count) const;
  void finish_normals(std::size_t i, const glm::dvec3& normal, const glm::dvec3& position) const;
  /// n' = s x + t y + n z with s along dp_du made perpendicular to n and t = n x s (research: mitsuba-truth).
  glm::dvec3 from_tangent_frame(const glm::dvec3& local, const glm::dvec3& n, std::size_t i) const;
  double finish_empty(std::size_t i) const;

  /// A component of a role that is a value of the surface.
  struct RolePlane {
    float* values;
    bool quotient;  ///< of layers that both carry coverage: it carries none
  };
  std::vector<RolePlane> role_planes() const;

  GBuffer& g_;
  const Reading& reading_;
  const LayerFrame frame_;
  const LooseLayers& loose_;
  const std::set<std::uint32_t> tangent_ids_, bumped_ids_;
  const bool made_albedo_ = is_made(reading_, "albedo");
  const bool made_positions_ = is_made(reading_, "position");
  const std::vector<RolePlane> role_planes_ = role_planes();
};

}  // namespace relume
