// An environment's light looked up, not summed. Diffuse: nine spherical harmonics of the irradiance (Ramamoorthi and Hanrahan 2001, "An Efficient
// Representation for Irradiance Environment Maps") times the lobe's own directional albedo. Specular: the image prefiltered for the lobe's width,
// towards the mirror direction, times the lobe's directional albedo, which is the split sum's second factor without its table (Karis 2013, "Real
// Shading in Unreal Engine 4").
#ifndef RELUME_ENVIRONMENT_PREFILTERED_H
#define RELUME_ENVIRONMENT_PREFILTERED_H

#include "kernels/ambient.h"
#include "kernels/environment/add.h"
#include "kernels/environment/map.h"

/// W/m^2 on a surface with the normal n, whose polynomial's coefficients the host makes; at least 0, which nine harmonics of a small sun fall below.
RELUME_FN real3 irradiance_at(RELUME_GLOBAL const float* harmonics, real3 n) {
  const real terms[9] = {all_lanes(1.0f), n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0f * n.z * n.z - 1.0f, n.x * n.z, n.x * n.x - n.y * n.y};
  real3 sum = grey(all_lanes(0.0f));
  for (int k = 0; k < 9; ++k)
    sum = add3(sum, real3_of(harmonics[3 * k] * terms[k], harmonics[3 * k + 1] * terms[k], harmonics[3 * k + 2] * terms[k]));
  return real3_of(larger(sum.x, all_lanes(0.0f)), larger(sum.y, all_lanes(0.0f)), larger(sum.z, all_lanes(0.0f)));
}

/// The image as a lobe of this width sees it around l: between two of the prefiltered ones, of which the image itself is the first.
RELUME_FN real3 prefiltered_at(RELUME_GLOBAL const EnvironmentRecord* map, RELUME_GLOBAL const float* tables, real3 l, real width) {
  const real level = square_root(clamped(width, 0.0f, 1.0f)) * (float)map->levels;
  const real below = smaller(whole_below(level), all_lanes((float)(map->levels - 1)));
  const integer size = to_integer(all_lanes((float)(map->level.width * map->level.height * 3)));
  const integer upper = to_integer(below) * size;
  const mask sharp = below < 0.5f;
  const MapPlace place = place_of(&map->level, map->world_from_map, l);
  const Corners corners = corners_of(&map->level, place);
  const real3 above = texels_at(&map->level, tables, corners, upper);
  const real3 beneath = texels_at(&map->level, tables, corners, choose_integer(sharp, upper, upper - size));
  const real3 image = texels_at(&map->image, tables, corners_of(&map->image, place_of(&map->image, map->world_from_map, l)), upper - upper);
  return mix3(choose3(sharp, image, beneath), above, level - below);
}

/// Adds the environment's light to pixels i .. i + RELUME_LANES - 1 of those whose program this is.
RELUME_FN void environment_prefiltered_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                                              RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists,
                                              RELUME_GLOBAL const float* tables, RELUME_GLOBAL float* out, int i) {
  (void)lights, (void)lists;
  const mask mine = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) == (float)frame->program;
  if (!any_of(mine)) return;
  const Surface s = surface_at(choice, planes, frame, tables, i);
  RELUME_GLOBAL const EnvironmentRecord* map = &frame->environment;
  const Basis basis = basis_of(s.n, s.v);
  const real3 irradiance = irradiance_at(tables + map->harmonics, s.n);
  const real3 diffuse = scale3(multiply3(irradiance, diffuse_albedo(choice, frame, s, basis)), all_lanes(RELUME_INVERSE_PI));
  real3 specular = grey(all_lanes(0.0f));
  if (choice.specular != SPECULAR_none) {
    const real3 mirrored = subtract3(scale3(s.n, 2.0f * s.n_v), s.v);
    const real3 radiance = prefiltered_at(map, tables, mirrored, lobe_width(frame->width_rule, choice.specular, s));
    specular = multiply3(radiance, specular_albedo(choice, frame, s, basis));
  }
  add_reflection(planes, frame, s, mine, diffuse, specular, grey(all_lanes(0.0f)), out, i);
}

#endif
