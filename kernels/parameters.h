// Every parameter that a lobe may have, once: the kernels' Surface, the JSON keys, --set, the layers' roles, help, docs and tests come from here.
// PARAMETER(name, components, default, lowest, highest, meaning)
#ifndef RELUME_PARAMETERS_H
#define RELUME_PARAMETERS_H

#define RELUME_PARAMETERS(PARAMETER)                                                                                           \
  PARAMETER(albedo, 3, 0.8, 0, 1, "diffuse reflectance; for metal-rough and principled lobes the base colour")                 \
  PARAMETER(kd, 3, 0.8, 0, 1, "the lecture's diffuse coefficient, without 1/pi")                                               \
  PARAMETER(ks, 3, 0.5, 0, 1, "specular coefficient")                                                                          \
  PARAMETER(exponent, 1, 32, 0, 10000, "Phong's and Blinn's exponent e")                                                       \
  PARAMETER(alpha, 1, 0.25, 0.0001, 1, "microfacet slope width, the square of roughness")                                      \
  PARAMETER(roughness, 1, 0.5, 0, 1, "perceptual roughness; alpha is its square")                                              \
  PARAMETER(f0, 3, 0.04, 0, 1, "Schlick's reflectance at normal incidence")                                                    \
  PARAMETER(f90, 3, 1, 0, 1, "Schlick's reflectance at grazing incidence")                                                     \
  PARAMETER(metallic, 1, 0, 0, 1, "0 dielectric, 1 metal: mixes f0 with the base colour")                                      \
  PARAMETER(ior, 1, 1.5, 1, 4, "index of refraction, interior over exterior")                                                  \
  PARAMETER(eta, 3, 0.2, 0.01, 10, "a conductor's real index of refraction, per channel")                                      \
  PARAMETER(k, 3, 3.9, 0, 20, "a conductor's extinction coefficient, per channel")                                             \
  PARAMETER(sigma, 1, 0.5, 0, 1.5707964, "Oren-Nayar's standard deviation of facet slope, radians")                            \
  PARAMETER(sigma_r, 1, 0.5, 0, 1, "roughness of energy-preserving Oren-Nayar")                                                \
  PARAMETER(diffuse_roughness, 1, 0, 0, 1, "roughness of Cycles' diffuse")                                                     \
  PARAMETER(nonlinear, 1, 0, 0, 1, "plastic: account for colour shifts by internal scattering (0 or 1)")                       \
  PARAMETER(flatness, 1, 0, 0, 1, "principled: blend towards the flat subsurface approximation")                               \
  PARAMETER(sheen, 1, 0, 0, 1, "principled: cloth-like grazing term")                                                          \
  PARAMETER(sheen_tint, 1, 0, 0, 1, "principled: tint of sheen towards the base colour")                                       \
  PARAMETER(specular_level, 1, 0.5, 0, 1, "specular level: 0.5 is an f0 of 0.04")                                              \
  PARAMETER(spec_tint, 1, 0, 0, 1, "principled: tint of the dielectric highlight towards the base colour")                     \
  PARAMETER(clearcoat, 1, 0, 0, 1, "principled: strength of the second, clear lobe")                                           \
  PARAMETER(clearcoat_gloss, 1, 0, 0, 1, "principled: gloss of the clear lobe")                                                \
  PARAMETER(base_color, 3, 0.8, 0, 1, "Cycles' base colour (its `albedo`), apart from the diffuse albedo that the pass holds") \
  PARAMETER(glossy_albedo, 3, 1, 0, 1, "Cycles' GlossCol: directional albedo of the glossy closures")                          \
  PARAMETER(transmittance, 1, -1, -1, 16777216, "set by the host: where rough plastic's table starts; -1: a smooth one")       \
  PARAMETER(fdr, 1, 0, 0, 1, "set by the host: plastic's internal diffuse Fresnel reflectance")                                \
  PARAMETER(table, 1, -1, -1, 2147483648, "a measured BRDF in MERL's format (a file)")

#endif
