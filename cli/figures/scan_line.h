// Gouraud interpolation beside Phong's, and a scan line of both: radiance, and its second difference, which is what an eye sees as Mach bands.
#pragma once

#include <string>

#include "cli/figures/lit_images.h"
#include "figure/figure.h"

namespace relume {

struct ScanLine {
  LitImage gouraud, phong;
  std::vector<std::int64_t> facets;  ///< of each pixel
  int row = 0;
  std::string lobes;  ///< for the title: "lambert + phong, exponent=50"
};

/// The row of the brightest pixel under Phong interpolation: through the highlight.
int row_of_highlight(const LitImage& phong, const std::vector<std::int64_t>& facets);

/// column,facet,gouraud,phong,gouraud_second_difference,phong_second_difference; pixels without a surface are left out.
std::string csv_of(const ScanLine& line);

/// `gouraud_png`, `phong_png`: the two images as files that gnuplot will read.
Figure figure_of(const ScanLine& line, const std::string& gouraud_png, const std::string& phong_png);

}  // namespace relume
