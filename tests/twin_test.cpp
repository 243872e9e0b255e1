// Twin: what the device computes is what the C++ twin computes, to the last bit, over hostile pixels and lights of every type, for every lane count.
// RELUME_LONG=1 takes every pair of lobes with every term on every lane count of the device (hours of compiling); without it the device takes every
// lobe once, and every pair with every term is held to agree among the twin's own lane counts.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/drivers/measure.h"

namespace relume {
namespace {

/// The first place where two results are not the same bits' value, or nothing. NaN never appears: the kernels write finite values.
std::string difference(const Planes& a, const Planes& b) {
  for (int plane = 0; plane < test_planes; ++plane)
    for (int i = 0; i < test_pixels; ++i) {
      const float x = a.plane(plane)[i], y = b.plane(plane)[i];
      if (std::isfinite(x) && std::isfinite(y) && ulps_between(x, y) == 0) continue;
      return "pixel " + std::to_string(i) + ", plane " + std::to_string(plane) + ": " + std::to_string(x) + " and " + std::to_string(y);
    }
  return {};
}

std::vector<NamedChoice> every_pair() {
  std::vector<NamedChoice> pairs;
  std::vector<const Lobe*> diffuse{nullptr}, specular{nullptr};
  for (const Lobe& lobe : diffuse_lobes()) diffuse.push_back(&lobe);
  for (const Lobe& lobe : specular_lobes()) specular.push_back(&lobe);
  for (const Lobe* d : diffuse)
    for (const Lobe* s : specular)
      for (const Term* f : offered(fresnels(), s ? s->fresnels : std::vector<std::string_view>{}, true))
        for (const Term* g : offered(shadowings(), s ? s->shadowings : std::vector<std::string_view>{}, true))
          for (const Term* n : offered(distributions(), s ? s->distributions : std::vector<std::string_view>{}, true))
            pairs.push_back({choice_of(d, s, f, g, n), d ? std::string(d->name) : "none", s ? std::string(s->name) : "none"});
  return pairs;
}

TEST(Twin, LaneCountsAgree) {
  const std::vector<NamedChoice> pairs = every_pair();
  const std::unique_ptr<Device> one = open_twin(1);
  for (const NamedChoice& pair : pairs) {
    const Planes expected = shade_test_band(*one, pair.choice, TestRange::whole);
    for (const int lanes : twin_lanes())
      EXPECT_EQ(difference(shade_test_band(*open_twin(lanes), pair.choice, TestRange::whole), expected), "")
          << pair.diffuse << " + " << pair.specular << " with " << lanes << " lanes";
  }
  std::printf("%zu programs agree on %zu lane counts\n", pairs.size(), twin_lanes().size());
}

TEST(Twin, DeviceAgrees) {
  const bool everything = std::getenv("RELUME_LONG") != nullptr;
  int compared = 0;
  for (const DeviceInfo& info : list_devices()) {
    if (!info.correctly_rounded) continue;  // tests/portability_test.cpp has their tolerances
    const std::vector<NamedChoice> programs = everything ? every_pair() : programs_of_all_lobes(false);
    for (const int lanes : {1, 4, 8, 16}) {
      const std::unique_ptr<Device> device = open_device(std::to_string(info.index), lanes);
      // Of the lane counts that are not the device's own, every third program will do: the twin's lanes agree on all.
      const std::size_t step = everything || lanes == info.lanes ? 1 : 3;
      for (std::size_t k = std::size_t(lanes) % step; k < programs.size(); k += step) {
        EXPECT_EQ(difference(shade_test_band(*device, programs[k].choice, TestRange::whole),
                             shade_test_band(*open_twin(), programs[k].choice, TestRange::whole)),
                  "")
            << info.name << ": " << programs[k].diffuse << " + " << programs[k].specular << " with " << lanes << " lanes";
        ++compared;
      }
    }
  }
  if (compared == 0) GTEST_SKIP() << "no OpenCL device that rounds divide and square root correctly";
  std::printf("%d programs of %d values, 0 ulp from the twin\n", compared, test_planes * test_pixels);
}

/// Programs that add an environment's light, for some of the lobes: what they do beside the lobes is the same for all.
TEST(Twin, EnvironmentsAgree) {
  const std::vector<NamedChoice> programs = programs_of_all_lobes(false);
  int compared = 0;
  for (const Entry environment : {Entry::environment_sampled, Entry::environment_prefiltered})
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const Planes expected = light_test_band(*open_twin(1), programs[k].choice, environment, TestRange::whole);
      const auto expect_alike = [&](Device& device) {
        EXPECT_EQ(difference(light_test_band(device, programs[k].choice, environment, TestRange::whole), expected), "")
            << device.info().name << ": " << programs[k].diffuse << " + " << programs[k].specular;
        ++compared;
      };
      for (const int lanes : twin_lanes()) expect_alike(*open_twin(lanes));
      for (const DeviceInfo& info : list_devices())
        if (info.correctly_rounded && k % 6 == 0) expect_alike(*open_device(std::to_string(info.index), k % 12 ? 1 : 0));
    }
  std::printf("%d programs of environments, 0 ulp from the twin of one lane\n", compared);
}

}  // namespace
}  // namespace relume
