// Every diffuse lobe, once. The kernel's choice, the JSON keys, --diffuse, help, docs and tests come from this list.
// LOBE(name, parameters, shadowings, fresnels, distributions, claims, source): the file is diffuse/<name>.h, the function diffuse_<name>;
// choices are separated by spaces, the default first; claims are the laws that tests and `relume check-brdf` hold it to: positive, reciprocal,
// conserving, and what pins its constants, of lab/laws/list.h, as law:argument:argument.
#ifndef RELUME_DIFFUSE_LIST_H
#define RELUME_DIFFUSE_LIST_H

#define RELUME_DIFFUSE_LOBES(LOBE)                                                                                                                 \
  LOBE(lambert, "albedo", "", "", "", "positive reciprocal conserving white lambertian", "Lambert 1760, Photometria")                              \
  LOBE(lambert_original, "kd", "", "", "", "positive reciprocal peak", "Lambert 1760 as lectures have it, without 1/pi")                           \
  LOBE(oren_nayar, "albedo sigma", "", "", "", "positive reciprocal lambertian:sigma=0", "Oren and Nayar 1994, Generalization of Lambert's Model") \
  LOBE(eon, "albedo sigma_r", "", "", "", "positive reciprocal conserving white lambertian:sigma_r=0", "Portsmouth, Kutz and Hill 2024, EON")      \
  LOBE(burley, "albedo roughness", "", "", "", "positive reciprocal normal", "Burley 2012, Physically-Based Shading at Disney")                    \
  LOBE(plastic, "albedo ior alpha roughness nonlinear", "", "", "", "positive reciprocal interface", "Mitsuba 3, plastic and roughplastic")        \
  LOBE(principled, "albedo roughness metallic flatness sheen sheen_tint", "", "", "", "positive reciprocal normal:flatness=0:metallic=0",          \
       "Burley 2012 and 2015 as in Mitsuba 3, principled")                                                                                         \
  LOBE(gltf, "albedo metallic f0 f90", "", "", "", "positive reciprocal conserving lambertian:f0=0:f90=0:metallic=0",                              \
       "glTF 2.0, appendix B, with KHR_materials_specular")                                                                                        \
  LOBE(cycles, "albedo diffuse_roughness", "", "", "", "positive reciprocal conserving white lambertian:diffuse_roughness=0",                      \
       "Cycles; Fujii's Oren-Nayar with OpenPBR's energy term")

#endif
