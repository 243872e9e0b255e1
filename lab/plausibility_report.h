// What was found of BRDFs' plausibility, as a table, as CSV, and as a figure.
#pragma once

#include <string>
#include <vector>

#include "figure/figure.h"
#include "lab/plausibility.h"

namespace relume {

/// A lobe, measured, and what was found of it.
struct LobeFindings {
  Examined lobe;
  std::vector<LawFinding> findings;
};

/// The least and the greatest directional albedo with all reflectances at 1, and where.
struct FurnaceRange {
  double least = 0, greatest = 0;
  std::string least_at, greatest_at;
  double error = 0;  ///< the greatest of the furnace
};
FurnaceRange range_of(const std::vector<FurnaceRow>& furnace);

/// A row for each lobe and each term; then, for people, each law that is not kept and by how much.
std::string table_text(const std::vector<LobeFindings>& lobes, const std::vector<LawFinding>& terms);

/// A row for each lobe, setting and angle: half, brdf, setting, view in degrees, albedo, error.
std::string albedo_csv(const std::vector<LobeFindings>& lobes);

/// Ranges of the white-furnace albedo of each lobe, beside the line that conserving lobes stay below.
Figure furnace_figure(const std::vector<LobeFindings>& lobes);

}  // namespace relume
