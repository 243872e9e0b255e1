// What lobes read from tables for a pixel, once: a compiler may not move loads out of the loop over lights, as it moves arithmetic.
#ifndef RELUME_LOOKUPS_H
#define RELUME_LOOKUPS_H

#include "kernels/choice.h"
#include "kernels/lobes.h"
#include "kernels/surface.h"

/// The surface with the members that its lobes look up. A file's guard tells whether a lobe of this program includes it.
RELUME_FN Surface looked_up(Choice choice, Surface s) {
  s.entering = s.one_bounce = s.one_bounce_mean = all_lanes(1.0f);
#ifdef RELUME_PLASTIC_H
  if (choice.diffuse == DIFFUSE_plastic) s.entering = plastic_transmittance(s, s.n_v);
#endif
#ifdef RELUME_MULTI_GGX_H
  const int cycles = choice.specular == SPECULAR_cycles_principled || choice.specular == SPECULAR_cycles_glossy;
  if (cycles && choice.distribution == DISTRIBUTION_multi_ggx) {
    s.one_bounce = multi_ggx_albedo(s);
    s.one_bounce_mean = multi_ggx_mean_albedo(s);
  }
#endif
  (void)choice;
  return s;
}

#endif
