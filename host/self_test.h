// Does this device compute what the C++ twin computes? Asked of every program before its results are believed.
#pragma once

#include "host/device.h"

namespace relume {

/// Shades a few dozen pixels, hostile ones among them, with every type of light on the device and on the twin; the largest relative difference, or
/// Error{device} naming the pixel and both values. Devices that round divide and square root correctly must agree bit for bit; others within
/// `self_test_tolerance`.
double self_test(Device& device, const Choice& choice);
/// The same of the program that adds an environment's light.
double self_test(Device& device, const Choice& choice, Entry environment);

/// The largest relative difference that passes on a device whose divide (2.5 ulp) and square root (3 ulp) are not correctly rounded. Such a device
/// strays by 5e-5 with ordinary parameters (docs/portability.md), but a mirror's lobe, of alpha 1e-5, makes 4e-3 of the last bits of a direction.
constexpr double self_test_tolerance = 5e-3;

}  // namespace relume
