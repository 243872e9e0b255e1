// check_image: the same planes and lights into two outputs.
#include "bench/image_check.h"

#include <algorithm>
#include <cstdio>

#include "gbuffer/error.h"
#include "host/self_test.h"
#include "host/test_band.h"
#include "host/twin.h"

namespace relume::bench {
namespace {

Planes shaded(Device& device, const ResidentFrame& resident, int pixels, bool culled) {
  Planes out = resident.make_out();
  Frame frame = resident.frame();
  LightLists lists;
  frame.lists = culled ? resident.list_lights(lists) : 0;
  frame.pixels = pixels;
  const auto band = device.bind(resident.data(out, lists.numbers()));
  band->shade(resident.choice(), frame, {});
  band->finish();
  return out;
}

/// "equal", or how far apart.
std::string compare(const Planes& here, const Planes& there, const DeviceInfo& info, int pixels) {
  const double allowed = info.correctly_rounded ? 0 : self_test_tolerance;
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < pixels; ++i) {
      const float a = here.plane(c)[i], b = there.plane(c)[i];
      largest = std::max(largest, test_difference(a, b));
      if (largest > allowed)
        throw Error(ErrorKind::device, info.name + ": not timed, its image is wrong: pixel " + std::to_string(i) + " is " + std::to_string(a) +
                                           ", the C++ twin has " + std::to_string(b));
    }
  if (largest == 0) return "equal";
  char text[32];
  std::snprintf(text, sizeof text, "within %.0e", largest);
  return text;
}

}  // namespace

std::string check_image(Device& device, const ResidentFrame& frame, int pixels) {
  return compare(shaded(device, frame, pixels, false), shaded(*open_twin(), frame, pixels, false), device.info(), pixels);
}

std::string check_culled_image(Device& device, const ResidentFrame& frame) {
  // All lights for all pixels would keep the twin busy for seconds: its own lists are held to brute force by light_lists_test, and here by some rows.
  const int all = frame.frame().pixels;
  constexpr std::int64_t most = 100'000'000;  // pixels times lights
  const int some = int(std::min<std::int64_t>(all, most / std::max(1, frame.lights())));
  const Planes here = shaded(device, frame, all, true);
  compare(here, shaded(*open_twin(), frame, some, false), device.info(), some);
  return compare(here, shaded(*open_twin(), frame, all, true), device.info(), all);
}

}  // namespace relume::bench
