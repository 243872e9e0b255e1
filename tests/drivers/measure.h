// The child's half of the portability test: every lobe on the one device that the environment offers, against the twin, a JSON line for each program.
#pragma once

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gbuffer/error.h"
#include "host/lobes.h"
#include "host/test_band.h"
#include "host/twin.h"

namespace relume {

/// Steps between two floats on the number line; -0 and 0 are one number.
inline std::int64_t ulps_between(float a, float b) {
  const auto place = [](float x) {
    const std::int32_t bits = std::bit_cast<std::int32_t>(x);
    return bits < 0 ? std::int64_t(INT32_MIN) - bits : std::int64_t(bits);
  };
  return std::abs(place(a) - place(b));
}

inline Choice choice_of(const Lobe* diffuse, const Lobe* specular, const Term* fresnel, const Term* shadowing, const Term* distribution) {
  const auto number = [](const auto* item) { return item ? item->number : 0; };
  return {number(diffuse), number(specular), number(fresnel), number(shadowing), number(distribution)};
}

/// What a program is built for, in words.
struct NamedChoice {
  Choice choice;
  std::string diffuse, specular;
};

/// The terms that a lobe offers; one null where it offers none.
inline std::vector<const Term*> offered(const std::vector<Term>& terms, const std::vector<std::string_view>& names, bool all) {
  std::vector<const Term*> found;
  for (const std::string_view name : names)
    if (all || found.empty()) found.push_back(find_term(terms, name));
  if (found.empty()) found.push_back(nullptr);
  return found;
}

/// Programs that together hold every lobe, and none of each half: a diffuse and a specular one share a program, for they have planes of their own.
/// `all_terms`: with every Fresnel, shadowing and distribution that the specular lobe offers, not the default ones alone.
inline std::vector<NamedChoice> programs_of_all_lobes(bool all_terms) {
  const std::vector<Lobe>&diffuse = diffuse_lobes(), &specular = specular_lobes();
  std::vector<NamedChoice> programs{{choice_of(&diffuse[0], nullptr, nullptr, nullptr, nullptr), std::string(diffuse[0].name), "none"},
                                    {choice_of(nullptr, &specular[0], nullptr, nullptr, nullptr), "none", std::string(specular[0].name)}};
  for (std::size_t i = 0; i < std::max(diffuse.size(), specular.size()); ++i) {
    const Lobe &d = diffuse[i % diffuse.size()], &s = specular[i % specular.size()];
    for (const Term* f : offered(fresnels(), s.fresnels, all_terms))
      for (const Term* g : offered(shadowings(), s.shadowings, all_terms))
        for (const Term* n : offered(distributions(), s.distributions, all_terms)) {
          std::string words(s.name);
          for (const Term* term : {f, g, n})
            if (term) words += " " + std::string(term->name);
          programs.push_back({choice_of(&d, &s, f, g, n), std::string(d.name), words});
        }
  }
  return programs;
}

/// The largest differences of one range of parameters, and where they were.
inline nlohmann::json measure_range(Device& device, const NamedChoice& program, TestRange range, int pixels) {
  const Planes here = shade_test_band(device, program.choice, range, pixels), there = shade_test_band(*open_twin(), program.choice, range, pixels);
  double worst = 0;
  std::string worst_at = "-";
  std::int64_t ulps = 0, differing = 0, nans = 0;
  for (int p = 0; p < test_planes; ++p)
    for (int i = 0; i < pixels; ++i) {
      const int plane = (p + 3) % test_planes;  // the lobes' own planes first, so that they get the blame before their sum
      const float a = here.plane(plane)[i], b = there.plane(plane)[i];
      if (std::isnan(a) != std::isnan(b)) ++nans;
      if (ulps_between(a, b) != 0) ++differing;
      if (std::max(std::fabs(a), std::fabs(b)) > 1e-3f) ulps = std::max(ulps, ulps_between(a, b));
      const double difference = std::min(test_difference(a, b), 1e30);  // JSON has no infinity
      if (difference <= worst) continue;
      worst = difference;
      const std::string both = program.diffuse + " + " + program.specular;
      worst_at = plane / 3 == 0 ? both : plane / 3 == 1 ? program.diffuse : plane / 3 == 2 ? program.specular : "ambient of " + both;
    }
  return {{"relative", worst}, {"at", worst_at}, {"ulps", ulps}, {"differing", differing}, {"values", test_planes * pixels}, {"nans", nans}};
}

/// A line for one program.
inline nlohmann::json measured(Device& device, const NamedChoice& program, int pixels) {
  const auto start = std::chrono::steady_clock::now();
  const nlohmann::json ordinary = measure_range(device, program, TestRange::ordinary, pixels);
  const std::chrono::duration<double> first = std::chrono::steady_clock::now() - start;  // nearly all of it is the build
  return {{"lobes", program.diffuse + " + " + program.specular},
          {"seconds", first.count()},
          {"ordinary", ordinary},
          {"whole", measure_range(device, program, TestRange::whole, pixels)}};
}

/// A line for the device and one for each program, the last `at_most` of them. Errors are lines too: the parent fails on them.
inline void measure(bool all_terms, std::size_t at_most, int lanes, int pixels, Precision precision) {
  const auto print = [](const nlohmann::json& line) { std::cout << line.dump() << std::endl; };
  try {
    const std::unique_ptr<Device> device = open_device("0", lanes, precision);
    const DeviceInfo& info = device->info();
    print({{"device", info.name}, {"driver", info.driver}, {"lanes", info.lanes}});
    std::vector<NamedChoice> programs = programs_of_all_lobes(all_terms);
    if (programs.size() > at_most) programs.erase(programs.begin(), programs.end() - std::ptrdiff_t(at_most));
    for (const NamedChoice& program : programs) print(measured(*device, program, pixels));
  } catch (const Error& error) {
    print({{"error", error.what()}});
  }
}

/// Shades the band of the self-test into fewer planes than it has layers: what a simulator must notice.
inline void overrun() {
  Planes in(test_pixels, 1), out(test_pixels, 1);
  in.add();
  out.add();
  Frame frame{};
  frame.pixels = test_pixels;
  frame.plane_stride = frame.out_stride = int(in.stride());
  frame.base_normal = frame.diffuse = frame.specular = frame.ambient_out = -1;
  frame.total = 1;  // the plane behind the last
  const std::vector<LightRecord> none;
  const std::vector<float> tables(1);
  const std::unique_ptr<Device> device = open_device("0");
  const std::unique_ptr<Band> band = device->bind({&in, none, {}, tables, &out});
  band->shade(choice_of(find_lobe(true, "lambert"), nullptr, nullptr, nullptr, nullptr), frame, {});
}

}  // namespace relume
