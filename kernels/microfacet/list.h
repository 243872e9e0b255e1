// The shadowing/masking terms G and the distributions of normals D that microfacet lobes may be given by name, once.
#ifndef RELUME_MICROFACET_LIST_H
#define RELUME_MICROFACET_LIST_H

#define RELUME_SHADOWINGS(SHADOWING)                                                                    \
  SHADOWING(v_groove, "Torrance and Sparrow 1967; Cook and Torrance 1982")                              \
  SHADOWING(smith, "height-correlated Smith: Heitz 2014, Understanding the Masking-Shadowing Function") \
  SHADOWING(smith_separable, "Smith 1967: G1(l) G1(v)")

#define RELUME_DISTRIBUTIONS(DISTRIBUTION)                                                         \
  DISTRIBUTION(multi_ggx, "Cycles' multiple-scattering GGX: GGX times an energy compensation")     \
  DISTRIBUTION(ggx, "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces") \
  DISTRIBUTION(beckmann, "Beckmann and Spizzichino 1963")

#endif
