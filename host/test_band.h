// A small made-up band that asks a device about every kind of light and parameter: what the self-test and the portability test compare.
#pragma once

#include "gbuffer/planes.h"
#include "host/device.h"

namespace relume {

/// How far the parameters go: `whole`, to the ends that their list allows; `ordinary`, without lobes so sharp that they magnify rounding
/// (alpha from 0.05, its like in roughness, Phong's exponent and gloss).
enum class TestRange { whole, ordinary };

constexpr int test_pixels = 83;  ///< no multiple of any lane count
constexpr int test_planes = 12;  ///< total, diffuse, specular, ambient: three each

/// The band shaded with the lobes of `choice`: hostile pixels among ordinary ones (NaN, zero normals, a light at the surface).
Planes shade_test_band(Device& device, const Choice& choice, TestRange range, int pixels = test_pixels);

/// The same band under a small environment alone; the last three planes have what samples say of their error.
Planes light_test_band(Device& device, const Choice& choice, Entry environment, TestRange range, int pixels = test_pixels);

/// The difference of two results relative to the larger; to 1e-3, a thousandth of a common pixel of the band, where both are smaller.
/// Infinite where one is NaN.
double test_difference(float a, float b);

}  // namespace relume
