// A BRDF as users choose it: a diffuse lobe plus a specular lobe, the lecture's decomposition. Each gives f_r n.l.
#ifndef RELUME_BRDF_H
#define RELUME_BRDF_H

#include "kernels/choice.h"
#include "kernels/cosines.h"
#include "kernels/lobes.h"  // made by the build from the lists: includes every lobe; for a device, only the program's own (host/program.cpp)
#include "kernels/surface.h"

#ifdef RELUME_OPENCL

#define RELUME_LOBE_(half, name) half##_##name
#define RELUME_LOBE(half, name) RELUME_LOBE_(half, name)

RELUME_FN real3 diffuse_none(Cosines c, Surface s) {
  (void)s;
  return grey(c.n_l * 0.0f);
}
RELUME_FN real3 specular_none(Cosines c, Surface s) { return diffuse_none(c, s); }

RELUME_FN real3 reflect_diffuse(int lobe, Cosines c, Surface s) {
  (void)lobe;
  return RELUME_LOBE(diffuse, RELUME_DIFFUSE)(c, s);
}

RELUME_FN real3 reflect_specular(int lobe, Cosines c, Surface s) {
  (void)lobe;
  return RELUME_LOBE(specular, RELUME_SPECULAR)(c, s);
}

#else

#define RELUME_CASE_DIFFUSE(name, ...) \
  case DIFFUSE_##name:                 \
    return diffuse_##name(c, s);
#define RELUME_CASE_SPECULAR(name, ...) \
  case SPECULAR_##name:                 \
    return specular_##name(c, s);

RELUME_FN real3 reflect_diffuse(int lobe, Cosines c, Surface s) {
  switch (lobe) { RELUME_DIFFUSE_LOBES(RELUME_CASE_DIFFUSE) }
  return grey(all_lanes(0.0f));
}

RELUME_FN real3 reflect_specular(int lobe, Cosines c, Surface s) {
  switch (lobe) { RELUME_SPECULAR_LOBES(RELUME_CASE_SPECULAR) }
  return grey(all_lanes(0.0f));
}

#endif
#endif
