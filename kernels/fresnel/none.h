// No Fresnel: the specular coefficient alone.
#ifndef RELUME_NONE_H
#define RELUME_NONE_H

#include "kernels/surface.h"

RELUME_FN real3 fresnel_none(Surface s, real v_h) {
  (void)v_h;
  return s.ks;
}

#endif
