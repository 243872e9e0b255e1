// Subjects yardstick/<brdf>/<who>: Relume's kernels beside plain C++ and the textbook kernel, on the same pixels under the same 64 unranged point
// lights.
#include <tbb/parallel_for.h>

#include <algorithm>

#include "bench/resident_subject.h"
#include "bench/suites.h"
#include "bench/textbook_kernel.h"
#include "bench/yardstick_scene.h"

namespace relume::bench {
namespace {

constexpr Yardstick yardsticks[] = {{"cook_torrance", "lambert+cook_torrance", "specular_cook_torrance", PlainBrdf::cook_torrance},
                                    {"ggx", "lambert+ggx", "specular_ggx", PlainBrdf::ggx},
                                    {"lambert", "lambert+none", "specular_none", PlainBrdf::lambert}};

/// Slow yardsticks shade the first rows only: rates are compared, and a pixel costs the same wherever it is.
constexpr int plain_share = 4, textbook_share = 16, pow_share = 64;

/// The same useful work as Relume's, whatever it takes to get there.
Work work_of(const YardstickScene& scene, int pixels) {
  const double pairs = double(scene.pixels()) * yardstick_lights, share = double(pixels) / scene.pixels();
  const Work all = work_of(*scene.relume(), pairs);
  return {{{"brute", pairs * share}}, all.flops * share, all.bytes * share};
}

Subject plain_subject(const std::string& name, PlainBrdf brdf, const std::shared_ptr<YardstickScene>& scene, bool one_thread, const Roof& roof) {
  const int pixels = scene->pixels() / plain_share;
  const auto out = std::make_shared<Planes>(scene->relume()->make_out());
  const auto run = [=] {
    const PlainPixels p = scene->plain_pixels(*out);
    const PlainLights l = scene->plain_lights();
    constexpr int block = 4096;  // pixels: a millisecond and more
    if (one_thread) return shade_plainly(brdf, p, l, 0, pixels);
    tbb::parallel_for(0, (pixels + block - 1) / block, [&](int k) { shade_plainly(brdf, p, l, k * block, std::min(pixels, (k + 1) * block)); });
  };
  run();
  return {name, run, work_of(*scene, pixels), scene->check(name, *out, pixels), roof};
}

Subject textbook_subject(const std::string& name, const Yardstick& y, const std::shared_ptr<YardstickScene>& scene, const BenchDevice& device,
                         bool with_pow) {
  const int pixels = scene->pixels() / (with_pow ? pow_share : textbook_share);
  const auto kernel = std::make_shared<TextbookKernel>(device, y, *scene, with_pow);
  kernel->shade(pixels);
  Planes out = scene->relume()->make_out();
  kernel->read(out);
  return {name, [=] { kernel->shade(pixels); }, work_of(*scene, pixels), scene->check(name, out, pixels), device.roof()};
}

/// Goals are for Cook-Torrance; the others are there to be seen.
std::vector<Claim> claims_of(const std::string& prefix, const BenchDevice& device, bool is_cook_torrance) {
  const auto goal = [&](double value) { return is_cook_torrance ? value : 0; };
  const std::string relume = prefix + "relume/" + device.label, one = prefix + "relume_1_thread/" + device.label;
  std::vector<Claim> all{{Measure::rate_over, relume, prefix + "cpp", "over plain C++, all threads", goal(4)},
                         {Measure::peak_share, relume, "", "of the multiply-add peak", goal(0.5)}};
  if (device.is_twin()) return all;
  all.push_back({Measure::rate_over, one, prefix + "cpp_1_thread", "over plain C++, one thread", goal(4)});
  all.push_back({Measure::rate_over, relume, prefix + "textbook/" + device.label, "over the textbook kernel with multiplications", goal(6)});
  all.push_back({Measure::rate_over, relume, prefix + "textbook_pow/" + device.label, "over the textbook kernel with pow", goal(30)});
  return all;
}

Group group_of(const Bench& bench, const Yardstick& y, Size size) {
  const std::string prefix = std::string("yardstick/") + y.name + "/";
  Group group;
  group.names = {prefix + "cpp", prefix + "cpp_1_thread"};
  for (const BenchDevice& d : bench.devices) {
    group.names.push_back(prefix + "relume/" + d.label);
    for (const Claim& claim : claims_of(prefix, d, y.plain == PlainBrdf::cook_torrance)) group.claims.push_back(claim);
    if (!d.is_twin())
      for (const char* who : {"relume_1_thread/", "textbook/", "textbook_pow/"}) group.names.push_back(prefix + who + d.label);
  }
  group.make = [&bench, &y, size, prefix](const std::function<bool(const std::string&)>& is_wanted) {
    const auto scene = std::make_shared<YardstickScene>(y, size);
    std::vector<Subject> made;
    const auto add = [&](const std::string& name, const auto& make) {
      if (is_wanted(prefix + name)) made.push_back(make(prefix + name));
    };
    for (const BenchDevice& d : bench.devices) {
      add("relume/" + d.label, [&](const auto& name) { return resident_subject(name, scene->relume(), d.open(), d.roof()); });
      if (const std::shared_ptr<Device> part = d.open_one_thread())
        add("relume_1_thread/" + d.label, [&](const auto& name) { return resident_subject(name, scene->relume(), part, d.roof(1)); });
      if (d.is_twin()) continue;
      add("textbook/" + d.label, [&](const auto& name) { return textbook_subject(name, y, scene, d, false); });
      add("textbook_pow/" + d.label, [&](const auto& name) { return textbook_subject(name, y, scene, d, true); });
    }
    add("cpp", [&](const auto& name) { return plain_subject(name, y.plain, scene, false, bench.processor_roof()); });
    add("cpp_1_thread", [&](const auto& name) { return plain_subject(name, y.plain, scene, true, Roof{bench.one_thread.fused, 1}); });
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> yardstick_groups(const Bench& bench) {
  const Size size = bench.options.sizes.empty() ? Size{1920, 1080} : bench.options.sizes.front();
  std::vector<Group> groups;
  for (const Yardstick& y : yardsticks) groups.push_back(group_of(bench, y, size));
  return groups;
}

}  // namespace relume::bench
