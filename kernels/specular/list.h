// Every specular lobe, once. The kernel's choice, the JSON keys, --specular, help, docs and tests come from this list.
// LOBE(name, parameters, shadowings, fresnels, distributions, claims, source): the file is specular/<name>.h, the function specular_<name>;
// choices are separated by spaces, the default first; claims are the laws that tests and `relume check-brdf` hold it to: positive, reciprocal,
// conserving, and what pins its constants, of lab/laws/list.h, as law:argument:argument.
#ifndef RELUME_SPECULAR_LIST_H
#define RELUME_SPECULAR_LIST_H

#define RELUME_SPECULAR_LOBES(LOBE)                                                                                                                \
  LOBE(phong_original, "ks exponent", "", "", "", "positive peak", "Phong 1975, Illumination for Computer Generated Pictures")                     \
  LOBE(phong, "ks exponent", "", "", "", "positive reciprocal conserving normalised", "Lafortune and Willems 1994, the modified Phong model")      \
  LOBE(blinn_phong_original, "ks exponent", "", "", "", "positive peak", "Blinn 1977, Models of Light Reflection")                                 \
  LOBE(blinn_phong, "ks exponent", "", "", "", "positive reciprocal normals", "Blinn 1977 as a distribution of normals")                           \
  LOBE(blinn_phong_exact, "ks exponent", "", "", "", "positive reciprocal conserving normalised", "Blinn 1977, normalised by Giesen 2009")         \
  LOBE(cook_torrance, "alpha roughness", "v_groove smith smith_separable", "schlick dielectric conductor none", "",                                \
       "positive reciprocal conserving facets:beckmann", "Cook and Torrance 1982, A Reflectance Model for Computer Graphics")                      \
  LOBE(beckmann, "alpha roughness", "smith smith_separable v_groove", "schlick dielectric conductor none", "",                                     \
       "positive reciprocal conserving facets:beckmann", "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces")            \
  LOBE(ggx, "alpha roughness", "smith smith_separable v_groove", "schlick dielectric conductor none", "",                                          \
       "positive reciprocal conserving facets:ggx", "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces")                 \
  LOBE(principled, "albedo roughness metallic specular_level ior spec_tint clearcoat clearcoat_gloss", "", "", "",                                 \
       "positive reciprocal facets:ggx:smith_separable clearcoat", "Burley 2012, Physically-Based Shading at Disney, as in Mitsuba 3, principled") \
  LOBE(cycles_principled, "roughness metallic base_color specular_level ior", "", "", "multi_ggx ggx",                                             \
       "positive facets:smith compensated:metallic=1",                                                                                             \
       "Cycles, Principled BSDF; Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks")                                         \
  LOBE(cycles_glossy, "glossy_albedo roughness", "", "", "multi_ggx ggx beckmann", "positive facets:smith compensated", "Cycles, Glossy BSDF")     \
  LOBE(merl, "table", "", "", "", "positive reciprocal", "Matusik et al. 2003, A Data-Driven Reflectance Model")

#endif
