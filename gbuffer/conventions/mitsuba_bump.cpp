// Mitsuba's shading normals judged shape by shape (research: mitsuba-truth, "sh_normal" and "normalmap/bumpmap").
#include "gbuffer/conventions/mitsuba_bump.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "gbuffer/samples.h"

namespace relume {
namespace {

using glm::dvec3;

constexpr double equal_normals = 2e-3;  // as a chord: twice the rounding of half precision

enum class Relief { none, smooth_mesh, perturbed };

/// What the pixels of one shape tell. Pairs are horizontal neighbours of the same shape.
struct ShapeEvidence {
  std::int64_t pixels = 0, differing = 0, pairs = 0, jumps = 0;
  double to_base = 0, to_z = 0;                       ///< sums of sh.geo and of sh.z
  double apart = 0, base_jump = 0, shading_jump = 0;  ///< sums of |sh - geo|, and over jumps of geo: of |d geo| and |d sh|
  std::set<std::uint32_t> primitives;

  bool local_frame() const { return to_z > to_base + 0.02 * double(pixels); }  // a bumpmap's normals lean on (0,0,1), whatever the surface

  /// Facets under smooth normals: geo jumps from facet to facet, sh passes over the jumps and stays within about a facet's turn of geo.
  Relief relief() const {
    if (differing * 200 < pixels) return Relief::none;
    const bool analytic = primitives.size() == 1;
    if (analytic || jumps == 0) return Relief::perturbed;
    const double turn = base_jump / double(jumps), follows = shading_jump / base_jump, lean = apart / double(pixels) / turn;
    const bool dense = 2 * jumps > pairs;  // facets near a pixel in size: sh seems to jump with geo, but stays close to it
    return lean < 1 && (dense || follows < 0.7) ? Relief::smooth_mesh : Relief::perturbed;
  }
};

struct Pixel {
  bool usable = false;
  std::uint32_t id = 0;
  dvec3 shading{0}, base{0};
};

Pixel pixel_at(const SampledBand& band, std::int64_t i) {
  Pixel pixel{false, 0, band.vector("normal", i), band.vector("base_normal", i)};
  const double id = band.has("ids") ? double(band.value("ids", i)) : 0;
  const auto unit = [](const dvec3& n) { return std::abs(glm::length(n) - 1) < 0.01; };
  pixel.usable = unit(pixel.shading) && unit(pixel.base) && id >= 0 && std::abs(id - std::round(id)) < 1e-2;
  if (!pixel.usable) return pixel;
  pixel.id = std::uint32_t(std::lround(id));
  pixel.shading = glm::normalize(pixel.shading);
  pixel.base = glm::normalize(pixel.base);
  return pixel;
}

void add_pixel(ShapeEvidence& shape, const Pixel& pixel) {
  const double apart = glm::distance(pixel.shading, pixel.base);
  ++shape.pixels;
  shape.differing += apart > equal_normals;
  shape.apart += apart;
  shape.to_base += glm::dot(pixel.shading, pixel.base);
  shape.to_z += pixel.shading.z;
}

void add_pair(ShapeEvidence& shape, const Pixel& a, const Pixel& b) {
  ++shape.pairs;
  const double jump = glm::distance(a.base, b.base);
  if (jump < 1e-6) return;  // one facet: the very same number, twice
  ++shape.jumps;
  shape.base_jump += jump;
  shape.shading_jump += glm::distance(a.shading, b.shading);
}

std::map<std::uint32_t, ShapeEvidence> evidence_of(const std::vector<SampledBand>& bands) {
  std::map<std::uint32_t, ShapeEvidence> shapes;
  for (const SampledBand& band : bands) {
    for (int y = 0; y < band.window.height(); ++y) {
      Pixel left;
      for (int x = 0; x < band.window.width(); ++x) {
        const std::int64_t i = band.index(x, y);
        const Pixel pixel = pixel_at(band, i);
        if (pixel.usable) {
          ShapeEvidence& shape = shapes[pixel.id];
          add_pixel(shape, pixel);
          if (band.has("primitive_ids")) shape.primitives.insert(std::uint32_t(band.value("primitive_ids", i)));
          if (left.usable && left.id == pixel.id) add_pair(shape, left, pixel);
        }
        left = pixel;
      }
    }
  }
  return shapes;
}

/// n' = s x + t y + n z, with s along dp_du made perpendicular to n, and t = n x s.
dvec3 from_local(const dvec3& local, const dvec3& n, const dvec3& dp_du) {
  const dvec3 s = glm::normalize(dp_du - n * glm::dot(n, dp_du));
  return s * local.x + glm::cross(n, s) * local.y + n * local.z;
}

/// Pixels of perturbed shapes whose shading normal looks away from the viewer although the surface does not.
std::int64_t turned_away(const std::vector<SampledBand>& bands, const Reading& reading, const std::set<std::uint32_t>& bumped,
                         const std::set<std::uint32_t>& local) {
  const Camera& camera = *reading.camera;
  std::int64_t count = 0;
  for (const SampledBand& band : bands) {
    for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
      const Pixel pixel = pixel_at(band, i);
      if (!pixel.usable || !bumped.contains(pixel.id)) continue;
      const bool turned = local.contains(pixel.id) && band.has("tangent");
      const dvec3 n = turned ? from_local(pixel.shading, pixel.base, band.vector("tangent", i)) : pixel.shading;
      const dvec3 v =
          camera.projection == Camera::Projection::orthographic ? camera.backward() : glm::normalize(camera.eye() - band.vector("position", i));
      constexpr double clear_of_rounding = 1e-4;
      count += glm::dot(n, v) < -clear_of_rounding && glm::dot(pixel.base, v) > clear_of_rounding;
    }
  }
  return count;
}

std::vector<std::uint32_t> some_of(const std::set<std::uint32_t>& ids, std::size_t shapes) {
  return ids.size() == shapes ? std::vector<std::uint32_t>{} : std::vector<std::uint32_t>(ids.begin(), ids.end());
}

std::string counted(std::size_t n, std::size_t of) { return std::to_string(n) + " of " + std::to_string(of) + (of == 1 ? " shape" : " shapes"); }

void settle_frame(Reading& reading, const std::set<std::uint32_t>& local, std::size_t shapes) {
  if (local.empty()) return;
  reading.normal_in_tangent_frame = reading.roles.contains("tangent");
  reading.tangent_ids = some_of(local, shapes);
  const std::string layer = reading.roles.at("normal").layer;
  if (reading.normal_in_tangent_frame)
    reading.notes.push_back(layer + " of " + counted(local.size(), shapes) +
                            " is in the surface's own frame (Mitsuba 3.9's bumpmap writes it so): turned to world by " +
                            reading.roles.at("base_normal").layer + " and " + reading.roles.at("tangent").layer);
  else
    reading.notes.push_back(
        "warning: " + layer + " of " + counted(local.size(), shapes) +
        " is in the surface's own frame (Mitsuba 3.9's bumpmap writes it so), and no dp_du layer says which way that lies: the light will be wrong");
}

void settle_shadowing(const std::vector<SampledBand>& bands, const ReadingOptions& options, Reading& reading, const std::set<std::uint32_t>& bumped,
                      const std::set<std::uint32_t>& local) {
  if (options.bump_shadowing) return;
  if (!reading.camera) {
    reading.bump_shadowing = BumpShadowing::smith;
    reading.notes.push_back(
        "no camera to tell by: Mitsuba's defaults for bump and normal maps are taken (--bump-shadowing horizon: use_shadowing_function was false)");
    return;
  }
  const std::int64_t away = turned_away(bands, reading, bumped, local);
  reading.bump_shadowing = away > 0 ? BumpShadowing::horizon : BumpShadowing::smith;
  reading.notes.push_back(away > 0
                              ? std::to_string(away) +
                                    " pixels have shading normals that look away from the viewer, which Mitsuba's defaults turn back: "
                                    "use_shadowing_function is taken to be off too (--bump-shadowing smith says otherwise)"
                              : "no shading normal looks away from the viewer, as with Mitsuba's defaults: use_shadowing_function is taken to be on "
                                "(--bump-shadowing horizon says otherwise)");
}

}  // namespace

void settle_mitsuba_bump(Samples& samples, const ReadingOptions& options, Reading& reading) {
  if (!reading.roles.contains("base_normal") || reading.roles.at("base_normal").channels == reading.roles.at("normal").channels) {
    reading.roles.erase("base_normal");
    return;
  }
  const auto& bands = samples.bands(reading, {"tangent", "primitive_ids"});
  const auto shapes = evidence_of(bands);
  std::set<std::uint32_t> local, bumped;
  std::size_t smooth = 0;
  for (const auto& [id, shape] : shapes) {
    const bool in_local_frame = shape.local_frame();
    const Relief relief = in_local_frame ? Relief::perturbed : shape.relief();
    if (in_local_frame) local.insert(id);
    if (relief == Relief::perturbed) bumped.insert(id);
    smooth += relief == Relief::smooth_mesh;
  }
  settle_frame(reading, local, shapes.size());
  if (smooth > 0)
    reading.notes.push_back(counted(smooth, shapes.size()) +
                            " have smooth normals over facets: the facets' own normals hold back no light in Mitsuba");
  if (bumped.empty()) {
    if (!options.bump_shadowing) reading.bump_shadowing = BumpShadowing::none;
    if (!options.map.contains("base_normal")) reading.roles.erase("base_normal");
    return;
  }
  reading.bumped_ids = some_of(bumped, shapes.size());
  reading.notes.push_back(counted(bumped.size(), shapes.size()) + " have shading normals perturbed by a bump or normal map");
  settle_shadowing(bands, options, reading, bumped, local);
}

}  // namespace relume
