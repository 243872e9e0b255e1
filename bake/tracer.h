// The nearest triangle along a ray: Embree finds it in single precision, double precision decides.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "bake/mesh.h"
#include "bake/viewing_rays.h"

namespace relume {

struct Hit {
  std::int64_t triangle = -1;  ///< position in Mesh::triangles; -1: none
  glm::dvec3 barycentrics{0};  ///< weights of the triangle's vertices; a ray that meets an edge may leave one a little below 0
  double distance = 0;         ///< the ray's t
};

class Tracer {
 public:
  /// Keeps a reference.
  explicit Tracer(const Mesh& mesh);
  ~Tracer();

  /// From t = 0, or all along the line with `from_behind`. From any thread; the same answer whichever tree Embree builds.
  Hit nearest(const Ray& ray, bool from_behind) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace relume
