// One light's part in the sum over lights: incident * f_r * n.l.
#ifndef RELUME_ONE_LIGHT_H
#define RELUME_ONE_LIGHT_H

#include "kernels/brdf.h"
#include "kernels/bump.h"
#include "kernels/lights.h"  // made by the build from the list: includes every light

typedef struct {
  real3 diffuse, specular;
} Radiance;

#define RELUME_LIGHT_OF_TYPE(name, ...) \
  if (k < frame->light_begin[LIGHT_##name + 1]) return light_##name(light, position);

/// Of light k; lights are sorted by type, so the branch goes one way for many lights in a row, and for all lanes. Behind the last type come points
/// that stand in for clusters of lights (host/light_tree.h).
RELUME_FN Incident incident_from(RELUME_GLOBAL const Frame* frame, RELUME_LIGHT const LightRecord* light, int k, real3 position) {
  RELUME_LIGHTS(RELUME_LIGHT_OF_TYPE)
  return light_point(light, position);
}

/// Which lanes show a surface to the viewer.
typedef struct {
  mask diffuse, specular;
} Seen;

/// The share of a light where the surface faces it, else 0.
RELUME_FN real facing_share(Incident in, Cosines c, Surface s, int bump_shadowing) {
  real share = choose(c.n_l > 0.0f, in.share, all_lanes(0.0f));
  if (bump_shadowing != BUMP_none) share = share * bump_visibility(bump_shadowing, s, in.l);
  return share;
}

/// The sum with one light's reflection.
RELUME_FN Radiance with_light(Radiance sum, Choice choice, RELUME_LIGHT const LightRecord* light, real share, Cosines c, Surface s, Seen seen) {
  const mask lit = share > 0.0f;
  const real3 irradiance = scale3(light_intensity(light), share), dark = grey(all_lanes(0.0f));
  sum.diffuse = fused3(irradiance, choose3(lit & seen.diffuse, reflect_diffuse(choice.diffuse, c, s), dark), sum.diffuse);
  sum.specular = fused3(irradiance, choose3(lit & seen.specular, reflect_specular(choice.specular, c, s), dark), sum.specular);
  return sum;
}

#endif
