// direction_pairs: random with a fixed seed, and a small grid of extremes.
#include "lab/direction_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace relume {

std::vector<DirectionPair> direction_pairs() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < 300; ++i) {
    const double cosine = i % 3 == 0 ? std::pow(10.0, -8 * unit(random)) : unit(random);
    const glm::dvec3 v = direction_at(1e-8 + 0.99999999 * unit(random), turn * unit(random));
    pairs.push_back({direction_at(cosine, turn * unit(random)), v});
    pairs.push_back({{-v.x, -v.y, v.z}, v});
  }
  for (const double z : {1.0, 1e-4, 1e-8})
    for (const double w : {1.0, 1e-4, 1e-8})
      for (const double azimuth : {0.0, 1.5, std::numbers::pi}) pairs.push_back({direction_at(z, azimuth), direction_at(w, 0)});
  return pairs;
}

glm::dvec3 direction_at(double cosine, double azimuth) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

DirectionPair facing(double cosine) {
  const glm::dvec3 h = direction_at(cosine, 0);
  return {h, h};
}

DirectionPair mirrored(double cosine) {
  const glm::dvec3 v = direction_at(cosine, 0);
  return {{-v.x, 0, v.z}, v};
}

std::string text_of(const DirectionPair& pair) {
  const auto degrees = [](const glm::dvec3& d) { return 180 / std::numbers::pi * std::atan2(std::hypot(d.x, d.y), d.z); };
  char text[80];
  std::snprintf(text, sizeof text, "view %.4g, light %.4g degrees", degrees(pair.v), degrees(pair.l));
  return text;
}

}  // namespace relume
