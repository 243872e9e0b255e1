// Point light: radiant intensity over the squared distance, with the falloffs of FORMATS.md.
#ifndef RELUME_POINT_H
#define RELUME_POINT_H

#include "kernels/lights/incident.h"

/// The share of the intensity that arrives at distance d. `windowed`: glTF KHR_lights_punctual's recommended range window.
RELUME_FN real falloff_at(RELUME_LIGHT const LightRecord* light, real d2, real inverse_d) {
  if (light->falloff == FALLOFF_none) return all_lanes(1.0f);
  if (light->falloff == FALLOFF_linear) return clamped((light->range - d2 * inverse_d) * light->falloff_scale, 0.0f, 1.0f);
  const real inverse_square = inverse_d * inverse_d;
  if (light->falloff == FALLOFF_inverse_square) return inverse_square;
  const real x2 = d2 * light->falloff_scale;
  return inverse_square * clamped(1.0f - x2 * x2, 0.0f, 1.0f);
}

RELUME_FN Incident light_point(RELUME_LIGHT const LightRecord* light, real3 position) {
  const real3 to_light = real3_of(light->position[0] - position.x, light->position[1] - position.y, light->position[2] - position.z);
  const real d2 = dot3(to_light, to_light), inverse_d = 1.0f / square_root(d2);
  Incident in;
  in.l = scale3(to_light, inverse_d);
  in.share = falloff_at(light, d2, inverse_d);
  return in;
}

#endif
