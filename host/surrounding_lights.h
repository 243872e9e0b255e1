// Every light that comes from all around, once: it has no place and no single direction, so it is no record of kernels/lights/list.h.
// LIGHT(name, keys, source)
#pragma once

#define RELUME_SURROUNDING_LIGHTS(LIGHT)                                                                                          \
  LIGHT(ambient, "intensity fraction", "incident radiance from everywhere, W/(m^2 sr), or a share of the mean direct irradiance") \
  LIGHT(environment, "texture intensity rotation world_from_light mapping", "incident radiance from a latitude-longitude image, W/(m^2 sr)")
