// What a light sends to a point: the direction towards it and its share of the light's intensity.
#ifndef RELUME_INCIDENT_H
#define RELUME_INCIDENT_H

#include "kernels/frame.h"
#include "kernels/vector.h"

typedef struct {
  real3 l;     // unit, from the surface to the light; 0 or NaN where the light is at the surface
  real share;  // of the intensity that arrives: times it, the irradiance on a surface that faces the light
} Incident;

RELUME_FN real3 light_intensity(RELUME_LIGHT const LightRecord* light) {
  return real3_of(all_lanes(light->intensity[0]), all_lanes(light->intensity[1]), all_lanes(light->intensity[2]));
}

#endif
