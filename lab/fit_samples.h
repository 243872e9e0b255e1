// What a BRDF is fitted to: some entries of a measured table, and in what measure they are compared.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/merl.h"
#include "lab/brdf.h"

namespace relume {

// METRIC(name, meaning): how residuals are measured.
#define RELUME_FIT_METRICS(METRIC)                                                                                        \
  METRIC(log, "ln(1 + f_r n.l), every entry alike: Low et al. 2012, BRDF Models for Accurate and Efficient Rendering")    \
  METRIC(cube_root, "the cube root of f_r n.l, every entry alike: Fores et al. 2012, Toward a Perceptually Based Metric") \
  METRIC(cosine, "f_r n.l, by the solid angles of l and v: Ngan et al. 2005, Experimental Analysis of BRDF Models")

#define RELUME_METRIC_NAME(name, meaning) name,
enum class FitMetric { RELUME_FIT_METRICS(RELUME_METRIC_NAME) };
#undef RELUME_METRIC_NAME

/// By its name; Error{input} lists the names.
FitMetric fit_metric_named(const std::string& name);
const char* name_of(FitMetric metric);

/// f_r n.l as the metric compares it.
double compressed(FitMetric metric, double reflectance);

struct FitSample {
  DirectionPair pair;
  glm::dvec3 f;   ///< f_r, 1/sr
  double weight;  ///< of all samples: 1
};

/// Entries that are measured in all channels, l and v no further than `grazing` degrees from the normal: at most some 9000, spread over the table,
/// every theta_h among them. Error{input} where there is none.
std::vector<FitSample> fit_samples(const MerlTable& table, FitMetric metric, double grazing, const std::string& place);

}  // namespace relume
