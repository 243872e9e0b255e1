// check_image: the same planes and lights into two outputs.
#include "bench/image_check.h"

#include <algorithm>
#include <cmath>
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
  FrameBounds bounds = resident.bounds();
  frame.lists = culled ? resident.list_lights(lists, bounds) : 0;
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

/// A copy of which only one of `each` blocks shows a surface.
Planes some_blocks(const ResidentFrame& resident, int each) {
  const Planes& from = resident.gbuffer().planes;
  Planes some(from.pixels(), from.count());
  some.add(from.count());
  std::copy_n(from.data(), from.stride() * std::size_t(from.count()), some.data());
  float* const program = some.plane(resident.frame().program_plane);
  for (int i = 0; i < resident.frame().pixels; ++i)
    if (i / RELUME_LISTED_PIXELS % each != 0) program[i] = -1;
  return some;
}

}  // namespace

std::string check_cut_image(Device& device, const ResidentFrame& frame, double error) {
  constexpr double most = 1.5e9;  // pixels times lights: a second or two
  const int each = int(std::ceil(frame.frame().pixels * double(frame.lights()) / most));
  const Planes cut = shaded(device, frame, frame.frame().pixels, true), some = some_blocks(frame, each);
  Planes brute = frame.make_out();
  BandData data = frame.data(brute);
  data.planes = &some;
  const auto band = device.bind(data);
  band->shade(frame.choice(), frame.frame(), {});
  band->finish();
  double worst = 0;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < frame.frame().pixels; ++i) {
      const double exact = brute.plane(c)[i], off = std::fabs(cut.plane(c)[i] - exact);
      if (some.plane(frame.frame().program_plane)[i] >= 0 && off > 0) worst = std::max(worst, exact > 0 ? off / exact : 1.0);
    }
  if (worst > error) throw Error(ErrorKind::device, device.info().name + ": not timed, the light tree is off by " + std::to_string(worst));
  char text[64];
  std::snprintf(text, sizeof text, "within %.2g (1 of %d pixels)", worst, each);
  return text;
}

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
