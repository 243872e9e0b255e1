// How environment lights are evaluated: the ways there are, and their options.
#pragma once

namespace relume {

/// Every way, once. METHOD(name, meaning)
#define RELUME_ENVIRONMENT_METHODS(METHOD)                                                                     \
  METHOD(sampled, "samples of light and lobes by multiple importance sampling, with an estimate of the error") \
  METHOD(prefiltered, "looked up: spherical harmonics and a prefiltered image; fast, approximate")             \
  METHOD(exact, "every texel as a directional light: the reference")                                           \
  METHOD(median_cut, "directional lights of equal energy")

#define RELUME_METHOD(name, ...) name,
enum class EnvironmentMethod { RELUME_ENVIRONMENT_METHODS(RELUME_METHOD) };
#undef RELUME_METHOD

struct EnvironmentOptions {
  EnvironmentMethod method = EnvironmentMethod::sampled;
  int samples = 64;  ///< sampled: for each pixel, rounded up to a multiple of 16
  bool brightest_alone = false;  ///< light from the brightest texel alone, with the energy of them all: the lecture's comparison
  int lights = 256;  ///< median_cut: directional lights for an environment
};

/// Whether a device evaluates the image for itself, rather than as directional lights.
inline bool is_on_device(EnvironmentMethod method) { return method == EnvironmentMethod::sampled || method == EnvironmentMethod::prefiltered; }

}  // namespace relume
