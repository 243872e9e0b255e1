// Spot light: a point light within a cone; between inner and outer it falls as the renderer at hand has it.
#ifndef RELUME_SPOT_H
#define RELUME_SPOT_H

#include "kernels/lights/point.h"
#include "kernels/math.h"

RELUME_FN real cone_at(RELUME_LIGHT const LightRecord* light, real cosine) {
  // A hard edge (inner = outer) would divide by zero: 1e-6 keeps it an edge. glTF's own guard is 1e-3, in the cosine.
  const float width = light->cone == CONE_linear ? light->outer - light->inner : light->inner - light->outer;
  const float scale = 1.0f / (width > 1e-6f ? width : 1e-6f);
  if (light->cone == CONE_linear) return clamped((light->outer - arc_cosine(cosine)) * scale, 0.0f, 1.0f);
  const real t = clamped((cosine - light->outer) * scale, 0.0f, 1.0f);
  return light->cone == CONE_smoothstep ? t * t * (3.0f - 2.0f * t) : t * t;
}

RELUME_FN Incident light_spot(RELUME_LIGHT const LightRecord* light, real3 position) {
  Incident in = light_point(light, position);
  const real cosine = -(in.l.x * light->direction[0] + in.l.y * light->direction[1] + in.l.z * light->direction[2]);
  in.share = in.share * cone_at(light, cosine);
  return in;
}

#endif
