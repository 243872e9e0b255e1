// YardstickScene: one ground, one set of lights.
#include "bench/yardstick_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/ground_frame.h"
#include "gbuffer/error.h"
#include "host/twin.h"

namespace relume::bench {
namespace {

/// Textbook formulas with approximate roots agree to a few thousandths; a wrong formula is off by far more.
constexpr double allowed_difference = 2e-2;

}  // namespace

YardstickScene::YardstickScene(const Yardstick& yardstick, Size size)
    : relume_(std::make_shared<ResidentFrame>(ground_source(size.width, size.height), material_named(yardstick.pair))),
      gbuffer_(ground_source(size.width, size.height).make({"albedo", "alpha"}, 0)),
      reference_(relume_->make_out()) {
  const std::vector<Light> lights = ground_lights(LightType::point, yardstick_lights);
  relume_->set_lights(lights);
  for (const auto member : {&Light::position, &Light::intensity})
    for (int c = 0; c < 3; ++c)
      for (const Light& light : lights) light_arrays_.push_back(float((light.*member)[c]));
  std::copy_n(relume_->frame().viewer, 3, eye_.begin());
}

std::vector<float> YardstickScene::light_records() const {
  std::vector<float> records;
  for (std::size_t k = 0; k < yardstick_lights; ++k)
    for (std::size_t c = 0; c < 6; ++c) records.push_back(light_arrays_[c * yardstick_lights + k]);
  return records;
}

PlainPixels YardstickScene::plain_pixels(Planes& out) {
  PlainPixels p{};
  for (int c = 0; c < 3; ++c) {
    p.position[c] = plane(gbuffer_.position, c);
    p.normal[c] = plane(gbuffer_.normal, c);
    p.albedo[c] = plane(gbuffer_.roles.at("albedo"), c);
    p.out[c] = out.plane(c);
    p.eye[c] = eye_[std::size_t(c)];
  }
  p.alpha = plane(gbuffer_.roles.at("alpha"));
  return p;
}

PlainLights YardstickScene::plain_lights() const {
  PlainLights l{{}, {}, yardstick_lights};
  for (std::size_t c = 0; c < 3; ++c) {
    l.position[c] = &light_arrays_[c * yardstick_lights];
    l.intensity[c] = &light_arrays_[(3 + c) * yardstick_lights];
  }
  return l;
}

std::string YardstickScene::check(const std::string& name, const Planes& out, int pixels) {
  if (pixels > reference_pixels_) {
    Frame frame = relume_->frame();
    frame.pixels = reference_pixels_ = pixels;
    const auto band = open_twin()->bind(relume_->data(reference_));
    band->shade(relume_->choice(), frame, {});
    band->finish();
  }
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < pixels; ++i) {
      const double a = out.plane(c)[i], b = reference_.plane(c)[i], difference = std::fabs(a - b) / std::max(std::fabs(b), 1e-6);
      if (!(difference <= allowed_difference))
        throw Error(ErrorKind::internal, name + ": not timed, its image is wrong: pixel " + std::to_string(i) + " is " + std::to_string(a) +
                                             ", the C++ twin has " + std::to_string(b));
      largest = std::max(largest, difference);
    }
  char text[32];
  std::snprintf(text, sizeof text, "within %.0e", largest);
  return text;
}

}  // namespace relume::bench
