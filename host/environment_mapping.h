// How tools lay the sphere of directions out on a latitude-longitude image: which way its left edge looks, and whether edge texels lie on the edge.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace relume {

// MAPPING(name, up, left, quarter, columns, rows, source): the image's upper edge looks `up`, its left edge at the horizon `left`, a quarter of its
// width further right `quarter`. `border`: the first and the last texel lie on the image's edges (columns: both in the same direction; rows: at the
// poles); `centre`: half a texel inside.
#define RELUME_ENVIRONMENT_MAPPINGS(MAPPING)                                                                                                    \
  MAPPING(openexr, (0, 1, 0), (0, 0, -1), (1, 0, 0), border, border, "OpenEXR, ImfEnvmap: the centre looks along +z")                           \
  MAPPING(usdlux, (0, 1, 0), (0, 0, -1), (1, 0, 0), border, border, "UsdLux DomeLight, texture:format latlong: OpenEXR's")                      \
  MAPPING(mitsuba, (0, 1, 0), (0, 0, -1), (1, 0, 0), centre, border, "Mitsuba 3, envmap: as OpenEXR's, but the columns")                        \
  MAPPING(blender, (0, 0, 1), (-1, 0, 0), (0, 1, 0), centre, centre, "Cycles, Environment Texture, equirectangular: the centre looks along +x") \
  MAPPING(oiio_y_up, (0, 1, 0), (0, 0, -1), (1, 0, 0), centre, centre, "OpenImageIO, LatLong Environment, oiio:updirection y")                  \
  MAPPING(oiio_z_up, (0, 0, 1), (-1, 0, 0), (0, -1, 0), centre, centre, "OpenImageIO, LatLong Environment, oiio:updirection z")                 \
  MAPPING(materialx, (0, 1, 0), (0, 0, 1), (-1, 0, 0), centre, centre, "MaterialX, latlong: the centre looks along -z")

struct EnvironmentMapping {
  std::string_view name;
  glm::dmat3 light_from_map;  ///< columns left, quarter, up: the map's own frame, azimuth from `left` towards `quarter`
  bool columns_on_border, rows_on_border;
  std::string_view source;

  glm::dvec3 up() const { return light_from_map[2]; }
};

/// OpenEXR's is the first, the default.
const std::vector<EnvironmentMapping>& environment_mappings();

}  // namespace relume
