// Layers whose pixels are means over several samples: which pixels of a window and its surroundings show one surface alone, and which are mixed.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

class Samples;

class FilteredLayers {
 public:
  /// Pixels that are looked at around one: filters reach 2 pixels, and a surface shows its slope within 2 more.
  static constexpr int reach = 4;

  enum class Mean {
    over_pixel,  ///< misses count as 0
    over_hits,   ///< misses do not count
    direction,   ///< of the mean, with a length of 1
    none         ///< what the pixel's centre shows
  };
  struct Layer {
    std::string role;
    int first, count;  ///< components: value(i)[first] ...
    Mean mean;
    double resolution;  ///< differences below it are noise
    bool relative;      ///< and it is a share of the value
    bool is_signed;     ///< else below 0 is impossible
  };

  FilteredLayers(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles);
  FilteredLayers(const FilteredLayers&) = delete;

  const std::vector<Layer>& layers() const { return layers_; }
  const Layer* layer(const std::string& role) const;
  int components() const { return components_; }

  std::size_t index(int x, int y) const { return std::size_t(y - window_.min_y) * std::size_t(window_.width()) + std::size_t(x - window_.min_x); }
  bool inside(int x, int y) const { return x >= window_.min_x && x < window_.max_x && y >= window_.min_y && y < window_.max_y; }
  const float* value(std::size_t i) const { return values_.data() + i * std::size_t(components_); }

  /// No surface.
  bool empty(std::size_t i) const { return kinds_[i] == Kind::empty; }
  /// One surface alone.
  bool pure(std::size_t i) const { return kinds_[i] == Kind::pure; }
  /// Perhaps a mean of several surfaces, or of one and nothing.
  bool mixed(std::size_t i) const { return kinds_[i] == Kind::mixed || kinds_[i] == Kind::fringe; }
  /// Whether two neighbours show the same surface.
  bool one_surface(std::size_t a, std::size_t b) const;

  /// From one surface to the next.
  struct Steps {
    std::int64_t soft = 0;  ///< pixels that lie between two
    std::int64_t hard = 0;  ///< neighbours in a row that show one each
  };
  /// Adds what the window holds.
  void look(Steps& steps, std::vector<Sighting>& mixed, std::vector<Sighting>& pure) const;

 private:
  enum class Kind : char {
    empty,
    broken,  ///< a value is not finite
    pure,
    mixed,
    fringe  ///< pure by its own layers, but beside another surface or background where these do not tell coverage
  };

  void add(const Reading& reading, const std::string& role, Mean mean, double resolution, bool relative = false);
  void read(const ExrFile& file, const Reading& reading);
  Kind kind_by_itself(const Reading& reading, std::size_t i) const;
  void settle_by_neighbours(bool mean_over_hits);
  bool in_a_block(int x, int y) const;
  bool beside_background(int x, int y) const;
  bool bends(int x, int y) const;
  glm::dvec3 vector(const Layer& layer, std::size_t i) const;
  /// In the position's space.
  glm::dvec3 normal(std::size_t i) const { return turn_ * vector(layers_[0], i); }

  Window window_;              ///< the one asked for, and what must be known around it
  std::vector<Layer> layers_;  ///< the normal is the first
  const Layer *position_ = nullptr, *ids_ = nullptr, *alpha_ = nullptr, *depth_ = nullptr;
  int components_ = 0;
  std::vector<float> values_;
  std::vector<Kind> kinds_;
  glm::dmat3 turn_{1.0};  ///< from the normal's stored components to the position's space
};

/// Within what averaging leaves of a whole number in single precision.
bool whole_number(double id);

/// Whether pixels are means over several samples: then surfaces meet in mixed pixels rather than abruptly. Looks at a few bands of rows.
bool looks_filtered(Samples& samples, const Reading& reading);

}  // namespace relume
