// Point light: radiant intensity over the squared distance, with the falloffs of FORMATS.md.
#ifndef RELUME_POINT_H
#define RELUME_POINT_H

#include "kernels/lights/incident.h"

/// The factor that turns intensity into irradiance at squared distance d2. `windowed`: glTF KHR_lights_punctual's recommended range window.
RELUME_FN real falloff_at(RELUME_GLOBAL const LightRecord* light, real d2) {
  real factor = 1.0f / d2;
  if (light->falloff == FALLOFF_windowed) {
    const real x2 = d2 / (light->range * light->range);
    factor = factor * clamped(1.0f - x2 * x2, 0.0f, 1.0f);
  } else if (light->falloff == FALLOFF_linear) {
    factor = clamped((light->range - square_root(d2)) / (light->range - light->range_begin), 0.0f, 1.0f);
  } else if (light->falloff == FALLOFF_none) {
    factor = all_lanes(1.0f);
  }
  return factor;
}

RELUME_FN Incident light_point(RELUME_GLOBAL const LightRecord* light, real3 position) {
  const real3 to_light = real3_of(light->position[0] - position.x, light->position[1] - position.y, light->position[2] - position.z);
  const real d2 = dot3(to_light, to_light);
  Incident in;
  in.l = scale3(to_light, 1.0f / square_root(d2));
  in.irradiance = scale3(light_intensity(light), falloff_at(light, d2));
  return in;
}

#endif
