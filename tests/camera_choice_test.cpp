// Which camera a reading gets: the header's where the positions bear it out, their own where they contradict it, the header's where there is depth
// alone, and one sentence where there is none.
#include <ImfFloatAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <half.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/find_camera.h"
#include "gbuffer/samples.h"
#include "tests/made_up_exr.h"

namespace relume {
namespace {

constexpr int width = 64, height = 48;
constexpr double scale = 60;  // pixels a unit of the tangent

/// A bumpy wall before a camera at (shift, 0, 5) that looks along -z.
glm::dvec3 wall(int x, int y, double shift) {
  const glm::dvec3 ray{(x + 0.5 - 0.5 * width) / scale, -(y + 0.5 - 0.5 * height) / scale, -1};
  return glm::dvec3(shift, 0, 5) + ray * (4 + std::sin(0.3 * x) * std::cos(0.2 * y));
}

double value(const std::string& channel, int x, int y, double shift) {
  const glm::dvec3 p = wall(x, y, shift);
  if (channel.starts_with("P.")) return p[channel.back() - 'X'];
  if (channel.starts_with("N.")) return channel == "N.Z";
  return channel == "Z" ? 5 - p.z : 0.5;
}

using Edit = MadeUpExr::Edit;

Edit header_camera(double eye_x, double degrees) {
  return [=](Imf::Header& header) {
    header.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, float(-eye_x), 0, 5, 1}));
    if (degrees > 0) header.insert("CameraFov", Imf::FloatAttribute(float(degrees)));
  };
}

const double true_degrees = 360 / M_PI * std::atan(0.5 * width / scale);

class CameraChoice : public testing::Test {
 protected:
  Reading chosen(const std::vector<std::string>& channels, const Edit& edit, const ReadingOptions& options = {}, double shift = 0) {
    const MadeUpExr made(
        {{"", "", channels}}, width, height, [&](const auto& c, int x, int y) { return value(c, x, y, shift); }, edit);
    return found(ExrFile(made.file), channels, options);
  }

  Reading found(const ExrFile& file, const std::vector<std::string>& channels, const ReadingOptions& options) {
    Reading reading;
    reading.data_window = reading.display_window = {0, 0, width, height};
    if (channels.front() == "Z") {
      reading.roles["depth"] = {0, "Z", {"Z"}, {SampleType::float32}};
    } else {
      reading.roles["position"] = {0, "P", {"P.X", "P.Y", "P.Z"}, {types, types, types}};
      reading.roles["normal"] = {0, "N", {"N.X", "N.Y", "N.Z"}, {types, types, types}};
    }
    reading.position_space = space;
    Samples samples(file);
    find_camera(samples, options, reading);
    return reading;
  }

  static std::string notes(const Reading& reading) {
    std::string all;
    for (const std::string& note : reading.notes) all += note + "\n";
    return all;
  }

  static void expect_true_lens(const Camera& camera, double tolerance = 1e-3) {
    ASSERT_TRUE(camera.lens);
    EXPECT_NEAR(camera.lens->scale_x, scale, tolerance);
    EXPECT_NEAR(camera.lens->scale_y, scale, tolerance);
    EXPECT_NEAR(camera.lens->centre_x, 0.5 * width, tolerance);
    EXPECT_NEAR(camera.lens->centre_y, 0.5 * height, tolerance);
  }

  Space space = Space::world;
  SampleType types = SampleType::float32;
  const std::vector<std::string> full{"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"}, depth_only{"Z"};
};

TEST_F(CameraChoice, TheHeadersWherePositionsBearItOut) {
  const Reading reading = chosen(full, header_camera(0, true_degrees));
  ASSERT_TRUE(reading.camera);
  EXPECT_EQ(reading.camera->source, "worldToCamera of the header");
  EXPECT_LT(reading.camera->residual, 1e-3);
  expect_true_lens(*reading.camera);
  EXPECT_EQ(notes(reading), "");
}

TEST_F(CameraChoice, ALensThatPositionsContradictIsSaid) {
  const Reading reading = chosen(full, header_camera(0, 20));
  ASSERT_TRUE(reading.camera);
  EXPECT_EQ(reading.camera->source, "worldToCamera of the header");
  expect_true_lens(*reading.camera);
  EXPECT_NE(notes(reading).find("the lens that the positions tell is used"), std::string::npos) << notes(reading);
}

TEST_F(CameraChoice, ThePositionsOwnWhereTheyContradictTheHeader) {
  const Reading reading = chosen(full, header_camera(3, true_degrees));
  ASSERT_TRUE(reading.camera);
  EXPECT_EQ(reading.camera->source, "recovered from P");
  EXPECT_LT(glm::distance(reading.camera->eye(), glm::dvec3(0, 0, 5)), 1e-3);
  expect_true_lens(*reading.camera);
  EXPECT_NE(notes(reading).find("the camera recovered from them is used instead"), std::string::npos) << notes(reading);
}

TEST_F(CameraChoice, EvenWhereTheHeaderIsAlmostRight) {
  const Reading reading = chosen(full, header_camera(0.05, true_degrees));  // the shutter opened somewhere else
  ASSERT_TRUE(reading.camera);
  EXPECT_LT(glm::distance(reading.camera->eye(), glm::dvec3(0, 0, 5)), 1e-3);
  EXPECT_NE(notes(reading).find("the camera recovered from them is used instead"), std::string::npos) << notes(reading);
}

TEST_F(CameraChoice, HalfPrecisionFarFromTheOriginDoesNotContradictTheHeader) {
  const double far = 900;
  types = SampleType::half_float;
  const MadeUpExr made(
      {{"", "", full}}, width, height, [&](const auto& c, int x, int y) { return double(float(half(float(value(c, x, y, far))))); },
      header_camera(far, true_degrees));
  const Reading reading = found(ExrFile(made.file), full, {});
  ASSERT_TRUE(reading.camera);
  EXPECT_GT(reading.camera->residual, 1) << "what rounding leaves";
  EXPECT_LT(glm::distance(reading.camera->eye(), glm::dvec3(far, 0, 5)), 1e-3);
  EXPECT_EQ(reading.camera->source, "worldToCamera of the header");
}

TEST_F(CameraChoice, DepthAloneTakesTheHeaders) {
  const Reading reading = chosen(depth_only, header_camera(0, true_degrees));
  ASSERT_TRUE(reading.camera);
  EXPECT_LT(glm::distance(reading.camera->eye(), glm::dvec3(0, 0, 5)), 1e-6);
  expect_true_lens(*reading.camera);
  EXPECT_NE(notes(reading).find("no positions to check it by"), std::string::npos) << notes(reading);
}

TEST_F(CameraChoice, DepthAloneTakesTheCameraGiven) {
  ReadingOptions options;
  options.camera = Camera{};
  options.camera->vertical_fov = 360 / M_PI * std::atan(0.5 * height / scale);  // as a rig states it, without a lens
  const Reading reading = chosen(depth_only, header_camera(3, true_degrees), options);
  ASSERT_TRUE(reading.camera);
  EXPECT_EQ(reading.camera->eye(), glm::dvec3(0));
  expect_true_lens(*reading.camera, 1e-9);
}

TEST_F(CameraChoice, DepthAloneWithoutACameraNamesTheOption) {
  const Reading none = chosen(depth_only, {});
  EXPECT_FALSE(none.camera);
  EXPECT_NE(notes(none).find("--camera FILE"), std::string::npos) << notes(none);
  const Reading blind = chosen(depth_only, header_camera(0, 0));
  EXPECT_FALSE(blind.camera);
  EXPECT_NE(notes(blind).find("has no field of view"), std::string::npos) << notes(blind);
}

TEST_F(CameraChoice, DepthAloneWithAFieldOfViewAloneIsLitInCameraSpace) {
  const Reading reading = chosen(depth_only, [](Imf::Header& header) { header.insert("CameraFov", Imf::FloatAttribute(float(true_degrees))); });
  ASSERT_TRUE(reading.camera);
  EXPECT_EQ(reading.camera->eye(), glm::dvec3(0));
  expect_true_lens(*reading.camera);
  EXPECT_NE(notes(reading).find("lights are taken in camera space"), std::string::npos) << notes(reading);
}

TEST_F(CameraChoice, CameraSpacePositionsTellTheLens) {
  space = Space::camera;
  // Seen from the origin the wall's own space is the camera's.
  const MadeUpExr made(
      {{"", "", full}}, width, height, [&](const auto& c, int x, int y) { return value(c, x, y, 0) - (c == "P.Z" ? 5 : 0); }, header_camera(7, 20));
  const Reading reading = found(ExrFile(made.file), full, {});
  ASSERT_TRUE(reading.camera);
  EXPECT_LT(glm::distance(reading.camera->eye(), glm::dvec3(7, 0, 5)), 1e-6);
  expect_true_lens(*reading.camera);
}

TEST_F(CameraChoice, TheFirstPartDescribesTheCameraOfItsViewOnly) {
  const auto of = [&](const std::string& view) {
    const MadeUpExr made(
        {{"left", "left", {"A"}}, {"right", view, {"Z"}}}, width, height, [&](const auto& c, int x, int y) { return value(c, x, y, 0); },
        header_camera(0, true_degrees));
    return header_cameras(ExrFile(made.file), 1, {0, 0, width, height}).size();
  };
  EXPECT_EQ(of("right"), 0u) << "the other eye";
  EXPECT_GT(of("left"), 0u);
  EXPECT_GT(of(""), 0u);
}

}  // namespace
}  // namespace relume
