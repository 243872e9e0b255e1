// A camera known exactly, and a header to state it in, for tests of what headers state.
#pragma once

#include <ImfFloatAttribute.h>
#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <random>
#include <sstream>

#include "gbuffer/camera_header.h"

namespace relume {

inline constexpr Window display{10, 20, 650, 380};
inline constexpr double degrees = 52;

/// As `matrix * column` needs it.
using Matrix = glm::dmat4;

class HeaderCameras : public testing::Test {
 protected:
  HeaderCameras() : header({{10, 20}, {649, 379}}, {{10, 20}, {649, 379}}) {
    truth.world_from_camera = glm::inverse(glm::lookAt(glm::dvec3(2.2, 1.9, 5.1), glm::dvec3(0.1, 0.5, -0.2), glm::dvec3(0, 1, 0)));
    truth.lens = Lens{scale, scale, 330, 200};
  }

  /// World to the camera that looks along +z.
  Matrix camera_from_world() const { return glm::scale(Matrix(1.0), {1, 1, -1}) * glm::inverse(truth.world_from_camera); }

  /// World to an image: x and y from [-1,1], y up, by factors and shifts; z/w from 0 to 1.
  Matrix image_from_world(const glm::dvec2& factor, const glm::dvec2& shift) const {
    Matrix projection(0.0);
    projection[0][0] = factor.x * 2 * scale / display.width();
    projection[1][1] = factor.y * 2 * scale / display.height();
    projection[2] = {shift.x, shift.y, 1.0001, 1};
    projection[3][2] = -0.1;
    return projection * camera_from_world();
  }
  Matrix screen() const { return image_from_world({1, 1}, {0, 0}); }
  Matrix ndc() const { return image_from_world({0.5, -0.5}, {0.5, 0.5}); }

  /// OpenEXR's storage, for row vectors.
  static std::vector<double> stored(const Matrix& m) { return {&m[0][0], &m[0][0] + 16}; }
  void put(const std::string& name, const Matrix& m) {
    Imath::M44f value;
    std::copy_n(&m[0][0], 16, &value.x[0][0]);
    header.insert(name, Imf::M44fAttribute(value));
  }
  void put(const std::string& name, double value) { header.insert(name, Imf::FloatAttribute(float(value))); }
  void put(const std::string& name, const std::string& value) { header.insert(name, Imf::StringAttribute(value)); }
  /// Not by Header::erase: OpenEXR 3.1.5's does not free the attribute.
  void forget(const std::string& name) {
    Imf::Header rest(header.displayWindow(), header.dataWindow());
    for (auto i = header.begin(); i != header.end(); ++i)
      if (i.name() != name) rest.insert(i.name(), i.attribute());
    header = rest;
  }
  static std::string listed(const std::vector<double>& numbers) {
    std::ostringstream text;
    text << std::setprecision(17);
    for (std::size_t i = 0; i < numbers.size(); ++i) text << (i ? ", " : "[") << numbers[i];
    return text.str() + "]";
  }

  void expect_first(double tolerance = 1e-5) {
    const auto cameras = header_cameras(header, display);
    ASSERT_FALSE(cameras.empty());
    expect_truth(cameras.front(), tolerance);
  }
  void expect_truth(const Camera& found, double tolerance = 1e-5) {
    SCOPED_TRACE(found.source);
    EXPECT_LT(glm::distance(found.eye(), truth.eye()), 10 * tolerance);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(found.world_from_camera[c], truth.world_from_camera[c]), tolerance) << c;
    ASSERT_EQ(found.lens.has_value(), truth.lens.has_value());
    if (!truth.lens) return;
    EXPECT_NEAR(found.lens->scale_x, truth.lens->scale_x, 1e3 * tolerance);
    EXPECT_NEAR(found.lens->scale_y, truth.lens->scale_y, 1e3 * tolerance);
    EXPECT_NEAR(found.lens->centre_x, truth.lens->centre_x, 1e3 * tolerance);
    EXPECT_NEAR(found.lens->centre_y, truth.lens->centre_y, 1e3 * tolerance);
  }
  /// The positions choose among what the header may mean.
  void expect_among() {
    std::vector<Sighting> sightings;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> side(-1, 1);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 point(side(random), side(random), side(random)), p(glm::inverse(truth.world_from_camera) * glm::dvec4(point, 1));
      sightings.push_back({330 - scale * p.x / p.z, 200 + scale * p.y / p.z, point});
    }
    double best = 1e9;
    Camera found;
    for (const Camera& camera : header_cameras(header, display))
      if (const double residual = fit_pose(camera, sightings).residual; residual < best) best = residual, found = camera;
    EXPECT_LT(best, 1e-2);
    EXPECT_LT(glm::distance(found.eye(), truth.eye()), 1e-4);
  }

  const double scale = 320 / std::tan(degrees / 2 * M_PI / 180);
  Imf::Header header;
  Camera truth;
};

}  // namespace relume
