// Every Fresnel term, once. FRESNEL(name, parameters, source): the file is fresnel/<name>.h, the function fresnel_<name>(surface, v.h) -> rgb.
#ifndef RELUME_FRESNEL_LIST_H
#define RELUME_FRESNEL_LIST_H

#define RELUME_FRESNELS(FRESNEL)                                                                                                 \
  FRESNEL(schlick, "f0 f90 metallic albedo", "Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering")           \
  FRESNEL(dielectric, "ior", "Fresnel's equations, unpolarised, as in Cook and Torrance 1982")                                   \
  FRESNEL(conductor, "eta k", "Fresnel's equations for a complex index, unpolarised; Born and Wolf, Principles of Optics, 14.2") \
  FRESNEL(none, "ks", "a constant, for the lecture's and for testing the other factors")

#endif
