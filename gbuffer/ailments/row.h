// A row of pixels for a doctor to look at: layers as stored, with the rows next to it, and what they mean.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "gbuffer/layer_frame.h"
#include "gbuffer/reading.h"

namespace relume {

/// Decoded channels of a band of rows: one plane a channel, however many roles share it.
class DecodedRows {
 public:
  /// Reads the roles that the reading has. `held`: the rows to read, within the reading's data window.
  DecodedRows(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles, const Window& held);

  const Window& window() const { return window_; }
  /// The first sample of a row of a role's component; null where the role, the component or the row is not held.
  const float* row(const std::string& role, int component, int y) const;

 private:
  Window window_;
  std::vector<std::vector<float>> planes_;
  std::map<std::string, std::vector<std::size_t>> by_role_;
};

/// What a pixel shows.
enum class Shown : char {
  nothing,
  mixture,  ///< a mean of several surfaces: a short normal, part of a coverage, a fraction of an id
  surface
};

struct Row {
  Row(const DecodedRows& band, const Reading& reading, const LayerFrame& frame, int y);

  const Reading& reading;
  const LayerFrame& frame;
  const DecodedRows& band;
  const int y, min_x, width;
  std::vector<Shown> shown;
  std::vector<float> length;       ///< of the normal, decoded; 1 where the file has no normals
  std::vector<glm::dvec3> normal;  ///< unit, world, as the reading has it; empty where the file has no normals
  std::vector<glm::dvec3> place;   ///< world; empty where the file has no positions

  /// The role's component in this row, or in one `down` rows below it; null where there is none.
  const float* stored(const std::string& role, int component = 0, int down = 0) const { return band.row(role, component, y + down); }
  std::vector<const float*> components(const std::string& role) const;

 private:
  void place_surfaces();
  void find_surfaces();
  void find_mixtures();
};

}  // namespace relume
