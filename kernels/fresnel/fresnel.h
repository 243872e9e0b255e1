// The Fresnel term that the program was built for.
#ifndef RELUME_FRESNEL_H
#define RELUME_FRESNEL_H

#include "kernels/choice.h"
#include "kernels/fresnels.h"  // made by the build from the list: includes every term
#include "kernels/surface.h"

#define RELUME_CASE_FRESNEL(name, ...) \
  case FRESNEL_##name:                 \
    return fresnel_##name(s, v_h);

RELUME_FN real3 fresnel_of(Surface s, real v_h) {
  switch (s.fresnel) { RELUME_FRESNELS(RELUME_CASE_FRESNEL) }
  return grey(all_lanes(0.0f));
}

#endif
