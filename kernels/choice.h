// Which lobes and terms a program is built for. In OpenCL the numbers are constants given at build time and the switches of brdf.h vanish;
// in C++ they are chosen when it runs.
#ifndef RELUME_CHOICE_H
#define RELUME_CHOICE_H

#include "kernels/diffuse/list.h"
#include "kernels/fresnel/list.h"
#include "kernels/lights/list.h"
#include "kernels/microfacet/list.h"
#include "kernels/specular/list.h"

#define RELUME_DIFFUSE_NUMBER(name, ...) DIFFUSE_##name,
#define RELUME_SPECULAR_NUMBER(name, ...) SPECULAR_##name,
#define RELUME_FRESNEL_NUMBER(name, ...) FRESNEL_##name,
#define RELUME_SHADOWING_NUMBER(name, ...) SHADOWING_##name,
#define RELUME_DISTRIBUTION_NUMBER(name, ...) DISTRIBUTION_##name,
#define RELUME_LIGHT_NUMBER(name, ...) LIGHT_##name,
enum { DIFFUSE_none, RELUME_DIFFUSE_LOBES(RELUME_DIFFUSE_NUMBER) DIFFUSE_COUNT };
enum { SPECULAR_none, RELUME_SPECULAR_LOBES(RELUME_SPECULAR_NUMBER) SPECULAR_COUNT };
enum { RELUME_FRESNELS(RELUME_FRESNEL_NUMBER) FRESNEL_COUNT };
enum { RELUME_SHADOWINGS(RELUME_SHADOWING_NUMBER) SHADOWING_COUNT };
enum { RELUME_DISTRIBUTIONS(RELUME_DISTRIBUTION_NUMBER) DISTRIBUTION_COUNT };
enum { RELUME_LIGHTS(RELUME_LIGHT_NUMBER) LIGHT_COUNT };

/// How a normal that points away from the viewer is treated; the values are gbuffer/reading.h's Facing.
enum { FACING_as_stored, FACING_one_sided, FACING_two_sided };
/// The values are gbuffer/reading.h's BumpShadowing.
enum { BUMP_none, BUMP_horizon, BUMP_smith };

typedef struct {
  int diffuse, specular, fresnel, shadowing, distribution;
} Choice;

#endif
