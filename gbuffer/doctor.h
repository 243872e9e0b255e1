// What is wrong with a G-buffer: every ailment of gbuffer/ailments/list.h, looked for in one pass over the channels that they need.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gbuffer/ailments/ailment.h"

namespace relume {

struct Diagnosis {
  Reading reading;
  bool understood = true;         ///< false: the file lacks what relighting needs, and `reading` holds what its names tell
  std::string why_not;            ///< then
  std::vector<Finding> findings;  ///< defects first

  bool sick() const;  ///< there is a defect
};

/// `lights`: the places of those lights that have one; half-precision positions are judged by the nearest. Throws Error{input} only for what the
/// options get wrong.
/// `understand`: another way to the reading, by a rig's camera, say.
using Understanding = std::function<Reading(const ExrFile&, const ReadingOptions&)>;
Diagnosis diagnose(const ExrFile& file, const ReadingOptions& options, const std::vector<glm::dvec3>& lights,
                   const Understanding& understand = relume::understand);

/// For each pixel of the reading's data window: 0, or 1 + the number of the last finding that the pixel has.
std::vector<std::uint8_t> mark_findings(const ExrFile& file, const Diagnosis& diagnosis, const std::vector<glm::dvec3>& lights);

}  // namespace relume
