// Every law that a lobe may claim (kernels/*/list.h), once: a file lab/laws/<name>.cpp with law_<name>, and its line here.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lab/examined.h"

namespace relume {

/// How far a lobe is from a law at its worst, and where.
struct Deviation {
  double by = 0;
  std::string where;  ///< empty: nowhere at all
  int tried = 0;

  void see(double deviation, const std::string& place) {
    ++tried;
    if (deviation <= by) return;
    by = std::isnan(deviation) ? std::numeric_limits<double>::infinity() : deviation;
    where = place;
  }
};

/// LAW(name, limit, what `by` is): kept where `by` is at most the limit. Limits are what single precision leaves, but where the line says otherwise.
/// Fits: Cycles' tables of albedo are bilinear, plastic's inner reflectance is Egan and Hilgeman's polynomial.
#define RELUME_LAWS(LAW)                                                                                           \
  LAW(positive, 0, "the most negative f_r n.l; infinite where it is no finite number")                             \
  LAW(reciprocal, 3e-6, "|f_r(l,v) - f_r(v,l)| over the larger")                                                   \
  LAW(conserving, 1e-4, "the greatest directional albedo above 1")                                                 \
  LAW(normalised, 1e-4, "how far the greatest directional albedo is from 1")                                       \
  LAW(white, 1e-4, "how far the directional albedo is from 1, at any angle")                                       \
  LAW(compensated, 2e-3, "how far the directional albedo is from 1, up to 80 degrees and from a roughness of 0.3") \
  LAW(lambertian, 2e-6, "how far pi f_r is from 1, with the arguments set")                                        \
  LAW(normal, 2e-6, "how far pi f_r is from 1 at l = v = n, with the arguments set")                               \
  LAW(peak, 2e-6, "how far the greatest f_r n.l is from 1")                                                        \
  LAW(normals, 1e-6, "how far the integral of f_r(h, h) n.h over facets h is from 1")                              \
  LAW(facets, 3e-6, "|f_r n.l - D G F/(4 n.v)| over the larger; D and, without a choice, G are the arguments")     \
  LAW(interface, 5e-3, "how far albedo and Fresnel reflectance together are from 1")                               \
  LAW(clearcoat, 1e-5, "how far the coat's D, of what it adds at l = v = h, is from a distribution of normals")

#define RELUME_DECLARE_LAW(name, limit, meaning) Deviation law_##name(const Examined& lobe, const std::vector<std::string>& arguments);
RELUME_LAWS(RELUME_DECLARE_LAW)
#undef RELUME_DECLARE_LAW

}  // namespace relume
