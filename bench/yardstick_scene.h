// What Relume and its yardsticks shade side by side: the ground under 64 unranged point lights, for Relume and as plain arrays.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/plain_shading.h"
#include "bench/resident_frame.h"
#include "bench/subject.h"

namespace relume::bench {

constexpr int yardstick_lights = 64;

/// A BRDF in its spellings.
struct Yardstick {
  const char* name;  ///< in names of subjects
  const char* pair;  ///< Relume's
  const char* lobe;  ///< in bench/textbook.cl
  PlainBrdf plain;
};

class YardstickScene {
 public:
  YardstickScene(const Yardstick& yardstick, Size size);

  const std::shared_ptr<ResidentFrame>& relume() const { return relume_; }
  int pixels() const { return relume_->frame().pixels; }

  /// `component` of position, normal, albedo or alpha; further components lie stride() floats on.
  float* plane(PlaneRange range, int component = 0) { return gbuffer_.planes.plane(range.first + component); }
  GBuffer& gbuffer() { return gbuffer_; }
  std::size_t stride() const { return gbuffer_.planes.stride(); }
  const std::array<float, 3>& eye() const { return eye_; }
  /// x, y, z, r, g, b, light by light.
  std::vector<float> light_records() const;

  PlainPixels plain_pixels(Planes& out);
  PlainLights plain_lights() const;

  /// Compares the first `pixels` with the twin's image, and says how far they are apart. Throws Error{internal} where that is more than a textbook
  /// formula's rounding.
  std::string check(const std::string& name, const Planes& out, int pixels);

 private:
  std::shared_ptr<ResidentFrame> relume_;
  GBuffer gbuffer_;
  std::vector<float> light_arrays_;  ///< x, y, z, r, g, b: one after the other
  Planes reference_;                 ///< the twin's image, as far as it was needed
  int reference_pixels_ = 0;
  std::array<float, 3> eye_;
};

}  // namespace relume::bench
