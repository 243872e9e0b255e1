// What a light sends to a point: the direction towards it and the irradiance on a surface that faces it.
#ifndef RELUME_INCIDENT_H
#define RELUME_INCIDENT_H

#include "kernels/frame.h"
#include "kernels/vector.h"

typedef struct {
  real3 l;           // unit, from the surface to the light; NaN where the light is at the surface
  real3 irradiance;  // W/m^2, facing the light
} Incident;

RELUME_FN real3 light_intensity(RELUME_GLOBAL const LightRecord* light) {
  return real3_of(all_lanes(light->intensity[0]), all_lanes(light->intensity[1]), all_lanes(light->intensity[2]));
}

#endif
