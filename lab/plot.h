// A plot: what is asked for, and the figure, the numbers and the sentences that come of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "gbuffer/picture.h"
#include "lab/arrangement.h"
#include "lab/measure.h"
#include "lab/scale.h"
#include "lab/subject.h"

namespace relume {

struct PlotRequest {
  Comparison compared;
  std::shared_ptr<Device> device;
  Arrangement arrangement;
  std::optional<double> marked;  ///< the moving direction that is drawn in with h, degrees
  Measure measure;
  std::optional<ScaleKind> scale;  ///< else what suits the kind
  std::optional<double> highest;   ///< else the highest value
  std::vector<LobePart> parts{LobePart::total};
  bool swap = false;     ///< also with view and light exchanged
  double exposure = 0;   ///< stops
  bool numbers = false;  ///< whether Plot::csv is wanted

  Brdf brdf(const Subject& subject) const { return {subject.brdf, subject.assignments(), device}; }
  /// What one curve or map shows: "phong, exponent = 8, specular".
  std::string label(const Subject& subject, LobePart part) const;
  /// A scale with room for `peak`, or for what was asked for.
  Scale scale_for(double peak, ScaleKind fallback, int decades = 4) const { return {scale.value_or(fallback), highest.value_or(peak), decades}; }
};

struct Plot {
  Figure figure;
  std::string csv;
  std::vector<std::string> remarks;  ///< a line each
  std::optional<Picture> picture;    ///< scene-linear, where the kind shades one
};

/// A text as gnuplot's markup shows it unchanged.
std::string plain(const std::string& text);

/// A title of two lines, the second one what does not vary.
std::string title_command(const PlotRequest& request, const std::string& first_line);

}  // namespace relume
