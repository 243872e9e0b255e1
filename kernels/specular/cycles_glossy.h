// Cycles' Glossy BSDF: a colour, the GlossCol pass, times a microfacet lobe without Fresnel.
#ifndef RELUME_CYCLES_GLOSSY_H
#define RELUME_CYCLES_GLOSSY_H

#include "kernels/microfacet/cycles_lobe.h"
#include "kernels/microfacet/multi_ggx.h"

RELUME_FN real3 specular_cycles_glossy(Cosines c, Surface s) {
  const real lobe = cycles_lobe(c, s);
  if (s.distribution != DISTRIBUTION_multi_ggx) return scale3(s.glossy_albedo, lobe);
  // GlossCol already holds the colour of the later bounces.
  return scale3(s.glossy_albedo, lobe * (1.0f / s.one_bounce));
}

#endif
