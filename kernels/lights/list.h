// Every light, once. LIGHT(name, keys, source): the file is lights/<name>.h, the function light_<name>(light, position) -> direction and incident
// rgb.
#ifndef RELUME_LIGHTS_LIST_H
#define RELUME_LIGHTS_LIST_H

#define RELUME_LIGHTS(LIGHT)                                                                                           \
  LIGHT(directional, "direction intensity", "irradiance on a surface that faces it, W/m^2 (glTF KHR_lights_punctual)") \
  LIGHT(point, "position intensity falloff range_begin range", "radiant intensity, W/sr (glTF KHR_lights_punctual)")   \
  LIGHT(spot, "position direction intensity inner_angle outer_angle cone falloff range_begin range", "radiant intensity on the axis, W/sr")

#endif
