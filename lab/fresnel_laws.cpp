// Laws of F: between 0 and 1, rising towards grazing incidence, and at its ends what optics says.
#include <algorithm>
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/term_laws.h"

namespace relume {
namespace {

/// A term's settings with the reflectance that they ought to have straight on and at grazing incidence.
struct Tried {
  Setting set;
  double normal, grazing;
  bool rises;  ///< from normal to grazing incidence
};

double squared_norm(double real, double imaginary) { return real * real + imaginary * imaginary; }

std::vector<Tried> tried_of(const std::string& fresnel) {
  std::vector<Tried> all;
  if (fresnel == "dielectric")
    for (const double ior : {1.01, 1.33, 1.5, 2.4, 4.0})
      all.push_back({{"ior=" + std::to_string(ior)}, std::pow((ior - 1) / (ior + 1), 2), 1, ior < 3.7});  // from 2 + sqrt(3) on it falls first
  if (fresnel == "conductor")
    for (const auto& [eta, k] : {std::pair{0.2, 3.9}, {1.5, 0.0}, {0.01, 20.0}, {10.0, 0.0}, {1.3, 7.5}, {2.9, 3.1}})
      all.push_back({{"eta=" + std::to_string(eta), "k=" + std::to_string(k)}, squared_norm(eta - 1, k) / squared_norm(eta + 1, k), 1, false});
  if (fresnel == "schlick")
    for (const double f0 : {0.0, 0.04, 0.5, 1.0})
      for (const double metallic : {0.0, 0.5, 1.0})
        all.push_back(
            {{"f0=" + std::to_string(f0), "f90=1", "albedo=0.6", "metallic=" + std::to_string(metallic)}, f0 + metallic * (0.6 - f0), 1, true});
  if (fresnel == "none")
    for (const double ks : {0.0, 0.5, 1.0}) all.push_back({{"ks=" + std::to_string(ks)}, ks, ks, true});
  return all;
}

}  // namespace

Deviation fresnel_bounded(const std::string& fresnel, const TermsWith& terms) {
  Deviation deviation;
  std::vector<DirectionPair> pairs;  // v.h is the cosine of half the angle between l and v: mirrored ones from straight on to grazing
  for (int i = 0; i <= 200; ++i) pairs.push_back(mirrored(std::cos(i / 200.0 * (std::numbers::pi / 2 - 1e-9))));
  for (const Tried& tried : tried_of(fresnel)) {
    const std::string text = text_of(tried.set);
    const std::vector<TermValues> values = terms(with_others(tried.set, {"fresnel=" + fresnel}))(pairs);
    deviation.see(std::abs(values.front().f.x - tried.normal), text + ", straight on");
    deviation.see(std::abs(values.back().f.x - tried.grazing), text + ", grazing");
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double f = values[i].f.x, fall = i && tried.rises ? values[i - 1].f.x - f : 0;
      deviation.see(std::max({-f, f - 1, fall}), text + ", " + text_of(pairs[i]));
    }
  }
  return deviation;
}

}  // namespace relume
