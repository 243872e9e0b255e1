// Tracer. Single precision is relative to the mesh's middle, and rays begin where they enter its ball: a camera far off costs no bits.
// Ties, at edges and where surfaces nearly touch, are decided by Moeller and Trumbore's test (1997) in double precision, then by number.
#include "bake/tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "gbuffer/error.h"
#include "gbuffer/watched.h"

namespace relume {
namespace {

/// What single precision may be wrong by, of the mesh's radius and the way through its ball: a few roundings of 6e-8, and plenty for grazing rays. A
/// larger one finds more candidates and the same answer.
constexpr double slack = 1e-5;

/// Embree's context, and the triangles that a second ray through the same point gathers.
struct Gathering {
  RTCIntersectContext context;  // first: Embree hands its address to the filter
  std::vector<std::uint32_t>* triangles;
};

void gather(const RTCFilterFunctionNArguments* found) {
  auto* const all = reinterpret_cast<const Gathering*>(found->context)->triangles;
  if (found->valid[0] != -1) return;
  all->push_back(RTCHitN_primID(found->hit, found->N, 0));
  found->valid[0] = 0;  // go on
}

bool keep_supervisor_quiet(void*, double) {
  beat();
  return true;
}

/// Where the line meets the triangle's plane; `distance` is not a number where it does not.
Hit meet(const Mesh& mesh, std::uint32_t index, const Ray& ray) {
  const MeshTriangle& triangle = mesh.triangles[index];
  const glm::dvec3 &a = mesh.corner(triangle, 0), ab = mesh.corner(triangle, 1) - a, ac = mesh.corner(triangle, 2) - a;
  const glm::dvec3 p = glm::cross(ray.direction, ac), from_a = ray.origin - a, q = glm::cross(from_a, ab);
  const double scale = 1 / glm::dot(ab, p), u = glm::dot(from_a, p) * scale, v = glm::dot(ray.direction, q) * scale;
  return {index, {1 - u - v, u, v}, glm::dot(ac, q) * scale};
}

double lowest(const glm::dvec3& weights) { return std::min({weights.x, weights.y, weights.z}); }

/// Inside before outside, then near before far, then by number.
bool better(const Hit& a, const Hit& b, double same_distance) {
  constexpr double on_edge = -1e-9;  // rounding of double precision: neither neighbour may let a ray through their edge
  const bool inside_a = lowest(a.barycentrics) >= on_edge, inside_b = lowest(b.barycentrics) >= on_edge;
  if (inside_a != inside_b) return inside_a;
  if (!inside_a) return lowest(a.barycentrics) > lowest(b.barycentrics);
  if (std::abs(a.distance - b.distance) > same_distance) return a.distance < b.distance;
  return a.triangle < b.triangle;
}

}  // namespace

struct Tracer::State {
  explicit State(const Mesh& of) : mesh(of), bounds(bounds_of(of)), middle(bounds.centre()), radius(bounds.radius()) {
    if (!device) throw Error(ErrorKind::internal, "Embree does not start");
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcSetSceneProgressMonitorFunction(scene, keep_supervisor_quiet, nullptr);
    attach();
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw Error(ErrorKind::memory, "not enough memory for a tree over the mesh's triangles");
  }
  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// In units of the radius from the middle: numbers near 1 whatever the mesh's size.
  glm::vec3 local(const glm::dvec3& point) const { return (point - middle) / radius; }

  void attach() const {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const points =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    auto* const corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (!points || !corners) throw Error(ErrorKind::memory, "not enough memory for the mesh's triangles");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      for (int c = 0; c < 3; ++c) points[3 * i + std::size_t(c)] = local(mesh.vertices[i].position)[c];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) std::copy_n(mesh.triangles[i].vertices.begin(), 3, corners + 3 * i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  const Mesh& mesh;
  const MeshBounds bounds;
  const glm::dvec3 middle;
  const double radius;
  const RTCDevice device = rtcNewDevice(nullptr);
  const RTCScene scene = rtcNewScene(device);
};

Tracer::Tracer(const Mesh& mesh) : state_(std::make_unique<State>(mesh)) {}

Tracer::~Tracer() = default;

Hit Tracer::nearest(const Ray& ray, bool from_behind) const {
  const State& s = *state_;
  const double length = glm::length(ray.direction), per_t = length / s.radius;  // Embree's distance for one of t
  const glm::dvec3 direction = ray.direction / length, to_middle = s.middle - ray.origin;
  const double closest = glm::dot(to_middle, direction), begin = from_behind ? closest - 2 * s.radius : std::max(closest - 2 * s.radius, 0.0);
  if (begin > closest + 2 * s.radius) return {};
  const glm::vec3 from = s.local(ray.origin + begin * direction), along(direction);
  Gathering context{};
  rtcInitIntersectContext(&context.context);
  RTCRayHit query{};
  query.ray = {from.x, from.y, from.z, 0, along.x, along.y, along.z, 0, INFINITY, ~0u, 0, 0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(s.scene, &context.context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  std::vector<std::uint32_t> candidates{query.hit.primID};
  const float way = query.ray.tfar, margin = float(slack * (1 + double(way)));
  context.triangles = &candidates;
  context.context.filter = gather;
  query.ray = {from.x, from.y, from.z, std::max(way - margin, 0.0f), along.x, along.y, along.z, 0, way + margin, ~0u, 0, 0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(s.scene, &context.context, &query);
  Hit best;
  for (const std::uint32_t candidate : candidates) {
    const Hit hit = meet(s.mesh, candidate, ray);
    if (!std::isfinite(hit.distance) || (!from_behind && hit.distance < 0)) continue;
    if (best.triangle < 0 || better(hit, best, 1e-12 / per_t)) best = hit;
  }
  return best;
}

}  // namespace relume
