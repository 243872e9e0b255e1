// A band of the G-buffer in memory, made plain: world space, unit normals, one coverage, parameters by role.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/mixtures.h"
#include "gbuffer/planes.h"
#include "gbuffer/reading.h"

namespace relume {

/// Planes that hold one role: `count` adjacent planes from `first`.
struct PlaneRange {
  int first = -1, count = 0;
};

struct GBuffer {
  Window window;  ///< the pixels held, row by row, no padding between rows
  Planes planes;
  PlaneRange position;                      ///< world, 3
  PlaneRange normal;                        ///< world, unit, 3; zero where there is no surface
  PlaneRange base_normal;                   ///< world, unit, 3: the unperturbed normal; count 0 where the reading has none
  PlaneRange coverage;                      ///< 1: share of the pixel that shows a surface, 0 where none; in (0, 1) only for filtered files
  bool fractional_coverage = false;         ///< some coverage lies strictly between 0 and 1 and must weigh the radiance
  std::map<std::string, PlaneRange> roles;  ///< the other roles that were asked for ("albedo", "roughness", "alpha", "uv", ...)
  std::vector<std::uint32_t> ids;           ///< object id of each pixel, if the role was asked for; else empty
  std::int64_t surface_pixels = 0;
  std::int64_t bad_pixels = 0;        ///< NaN or infinite position or normal: treated as showing no surface, and said so
  std::vector<std::int64_t> homes{};  ///< after the window's pixels come further surfaces of mixed ones: the pixel of each

  std::int64_t samples() const { return window.pixels() + std::int64_t(homes.size()); }
};

/// Reads a window: decodes only what is asked for, then decodes normals, renormalises, divides by coverage, takes camera space to world.
/// `roles`: those wanted besides position, normal, base_normal and coverage. `spare_planes`: room for the caller's own.
/// `mixtures` of the same window and roles: pixels that are taken apart.
GBuffer read_gbuffer(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles, int spare_planes,
                     const Mixtures& mixtures = {});

}  // namespace relume
