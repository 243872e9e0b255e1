// One pixel of the G-buffer (or RELUME_LANES of them) as the lobes see it.
#ifndef RELUME_SURFACE_H
#define RELUME_SURFACE_H

#include "kernels/parameters.h"
#include "kernels/vector.h"

#define RELUME_MEMBER_1 real
#define RELUME_MEMBER_3 real3
#define RELUME_MEMBER(name, components, ...) RELUME_MEMBER_##components name;

typedef struct {
  real3 position;  // world
  real3 n;         // unit, world
  real3 v;         // unit, from the surface to the viewer
  real n_v;        // n.v
  real3 base_n;    // the unperturbed normal; n where the file has none
  RELUME_GLOBAL const float* tables;
  int fresnel, shadowing, distribution;  // the program's choice of terms
  // From tables, by kernels/lookups.h:
  real entering;                     // plastic: the share of light from the viewer's direction that enters the surface
  real one_bounce, one_bounce_mean;  // Cycles' lobes: GGX's albedo in the viewer's direction, and its mean
  RELUME_PARAMETERS(RELUME_MEMBER)
} Surface;

#endif
