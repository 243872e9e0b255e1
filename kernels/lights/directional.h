// Directional light: the same direction and irradiance everywhere (glTF KHR_lights_punctual, "directional").
#ifndef RELUME_DIRECTIONAL_H
#define RELUME_DIRECTIONAL_H

#include "kernels/lights/incident.h"

RELUME_FN Incident light_directional(RELUME_LIGHT const LightRecord* light, real3 position) {
  (void)position;
  Incident in;
  in.l = real3_of(all_lanes(-light->direction[0]), all_lanes(-light->direction[1]), all_lanes(-light->direction[2]));
  in.share = all_lanes(1.0f);
  return in;
}

#endif
