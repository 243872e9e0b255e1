// self_test: a small made-up band through the device and the twin.
#include "host/self_test.h"

#include <algorithm>
#include <string>

#include "gbuffer/error.h"
#include "host/test_band.h"
#include "host/twin.h"

namespace relume {

namespace {

double compared(const Device& device, const Planes& here, const Planes& there) {
  const double allowed = device.info().correctly_rounded ? 0 : self_test_tolerance;
  double largest = 0;
  for (int plane = 0; plane < test_planes; ++plane)
    for (int i = 0; i < test_pixels; ++i) {
      const float a = here.plane(plane)[i], b = there.plane(plane)[i];
      largest = std::max(largest, test_difference(a, b));
      if (largest > allowed)
        throw Error(ErrorKind::device, device.info().name + ": self-test: pixel " + std::to_string(i) + " of plane " + std::to_string(plane) +
                                           " is " + std::to_string(a) + ", the C++ twin has " + std::to_string(b) +
                                           " (--device twin needs no driver)");
    }
  return largest;
}

}  // namespace

double self_test(Device& device, const Choice& choice) {
  return compared(device, shade_test_band(device, choice, TestRange::whole), shade_test_band(*open_twin(), choice, TestRange::whole));
}

double self_test(Device& device, const Choice& choice, Entry environment) {
  return compared(device, light_test_band(device, choice, environment, TestRange::whole),
                  light_test_band(*open_twin(), choice, environment, TestRange::whole));
}

}  // namespace relume
