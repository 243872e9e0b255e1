// Headers made up in every way that renderers state a camera, in every attribute type, against one camera known exactly.
#include "gbuffer/camera_header.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <random>
#include <sstream>

namespace relume {
namespace {

constexpr Window display{10, 20, 650, 380};
constexpr double degrees = 52;

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

TEST_F(HeaderCameras, OpenExrsOwn) {
  put("worldToCamera", camera_from_world());
  put("worldToNDC", ndc());
  expect_first();
  EXPECT_NEAR(header_cameras(header, display).front().vertical_fov, 2 * std::atan(180 / scale) * 180 / M_PI, 1e-4);
}

TEST_F(HeaderCameras, ScreenUnderEitherName) {
  put("worldToCamera", camera_from_world());
  put("worldToNDC", screen());  // Arnold 5 and 3Delight
  expect_first();
  header.erase("worldToNDC");
  put("worldToScreen", screen());
  expect_first();
}

TEST_F(HeaderCameras, AProjectionAlone) {
  put("worldToNDC", ndc());
  expect_first(1e-4);
  header.erase("worldToNDC");
  put("worldToScreen", screen());
  expect_first(1e-4);
}

TEST_F(HeaderCameras, Pbrts) {
  put("worldToCamera", glm::transpose(camera_from_world()));
  const double shorter = double(display.width()) / display.height();  // [0,1] spans the shorter side, y up
  put("worldToNDC", glm::transpose(image_from_world({0.5 * shorter, 0.5}, {0.5, 0.5})));
  expect_first();
}

TEST_F(HeaderCameras, OffCentreAndNonSquare) {
  header.pixelAspectRatio() = 2;
  truth.lens->scale_x *= 0.5;
  truth.lens->centre_x += 0.1 * 320;
  put("worldToCamera", camera_from_world());
  put("worldToNDC", image_from_world({0.25, -0.5}, {0.55, 0.5}));
  expect_first();
  header.erase("worldToNDC");
  put("worldToScreen", image_from_world({0.5, 1}, {0.1, 0}));
  expect_first();
}

TEST_F(HeaderCameras, LowerCaseAsOpenImageIoHadItAndPrefixedAsNukeHasIt) {
  put("worldtocamera", camera_from_world());
  put("exr/worldToNDC", ndc());
  expect_first();
}

TEST_F(HeaderCameras, AnyTypeOfAttribute) {
  const auto numbers = stored(camera_from_world());
  header.insert("worldToCamera", Imf::FloatVectorAttribute({numbers.begin(), numbers.end()}));
  put("worldToNDC", listed(stored(ndc())));
  expect_first();
  Imath::M44d matrix;
  std::copy_n(numbers.begin(), 16, &matrix.x[0][0]);
  header.erase("worldToCamera");
  header.insert("worldToCamera", Imf::M44dAttribute(matrix));
  expect_first();
}

TEST_F(HeaderCameras, FieldsOfView) {
  put("worldToCamera", camera_from_world());
  put("fieldOfViewHorizontal", degrees);
  expect_first();
  header.erase("fieldOfViewHorizontal");
  put("fieldOfViewVertical", 2 * std::atan(180 / scale) * 180 / M_PI);
  expect_first();
  header.erase("fieldOfViewVertical");
  header.insert("CameraFov", Imf::IntAttribute(int(degrees)));
  expect_first();
  header.erase("CameraFov");
  put("focal", 0.5 * 36 * scale / 320);
  put("haperture", 36);
  expect_first();
  header.erase("focal");
  put("nominalFocalLength", 0.5 * 36 * scale / 320);
  header.insert("sensorOverallDimensions", Imf::V2fAttribute({36, 20.25f}));
  expect_first();
  header.erase("sensorOverallDimensions");
  header.screenWindowWidth() = float(640 / scale);
  expect_first();
  header.screenWindowWidth() = 1;
  truth.lens.reset();
  expect_first();
}

TEST_F(HeaderCameras, OpenGlsViewAndTheCamerasOwnTransform) {
  put("worldToCamera", glm::inverse(truth.world_from_camera));
  expect_among();
  header.erase("worldToCamera");
  put("worldToCamera", truth.world_from_camera);
  expect_among();
}

TEST_F(HeaderCameras, VrayOf3dsMaxAndOfMaya) {
  const Matrix y_up = truth.world_from_camera;
  put("cameraFov", degrees);
  Matrix maya = y_up;  // right, backward, down
  maya[1] = y_up[2];
  maya[2] = -y_up[1];
  put("cameraTransform", maya);
  expect_first();
  header.channels().insert("VRayNormals.X", Imf::Channel());  // one sign alone does not outweigh a level camera
  expect_first();
  header.erase("cameraTransform");
  truth.world_from_camera = Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1) * y_up;  // the same scene with z up
  put("cameraTransform", truth.world_from_camera);
  expect_first();
}

TEST_F(HeaderCameras, VrayLookingLevelIsToldByWhereItLooksOrByTheSceneFile) {
  put("cameraFov", degrees);
  // Measured on V-Ray for Maya 3.60: the camera at (0, 5, 20) looks along -z, but 3ds Max's axes would be as level.
  put("cameraTransform", Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 5, 20, 1));
  const auto front = [&] { return header_cameras(header, display).front(); };
  EXPECT_LT(glm::distance(front().backward(), glm::dvec3(0, 0, 1)), 1e-6) << front().source;
  EXPECT_NE(front().source.find("Maya"), std::string::npos);
  put("vrayInfo/filename", "C:\\scenes\\shot.MAX");
  EXPECT_LT(glm::distance(front().backward(), glm::dvec3(0, -1, 0)), 1e-6) << front().source;
  EXPECT_NE(front().source.find("vrayInfo names it"), std::string::npos);
}

TEST_F(HeaderCameras, VrayThroughOpenImageIo) {
  Matrix maya = truth.world_from_camera;
  maya[1] = truth.world_from_camera[2];
  maya[2] = -truth.world_from_camera[1];
  put("worldToCamera", maya);
  put("cameraFov", degrees);
  put("cameraAperture", 36);
  expect_first();
}

TEST_F(HeaderCameras, Redshift) {
  Matrix transform = truth.world_from_camera;
  transform[2] *= -1.0;
  put("rs/camera/fov", degrees);
  put("rs/camera/transform", transform);
  expect_first();
  transform[0] *= -1.0;  // turned half way about y instead
  header.erase("rs/camera/transform");
  const auto numbers = stored(transform);
  header.insert("rs/camera/transform", Imf::FloatVectorAttribute({numbers.begin(), numbers.end()}));
  expect_first();
}

TEST_F(HeaderCameras, Unreal) {
  const double pitch = -12.5, yaw = 160, roll = 7, p = glm::radians(pitch), y = glm::radians(yaw), r = glm::radians(roll);
  const glm::dvec3 forward(std::cos(p) * std::cos(y), std::cos(p) * std::sin(y), std::sin(p)), level(-std::sin(y), std::cos(y), 0);
  const glm::dvec3 above(-std::sin(p) * std::cos(y), -std::sin(p) * std::sin(y), std::cos(p));
  const glm::dvec3 right = level * std::cos(r) - above * std::sin(r), up = above * std::cos(r) + level * std::sin(r);
  truth.world_from_camera = Matrix(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(-forward, 0), {220, 510, 190, 1});
  for (const auto& [name, value] : {std::pair{"curPos/x", "220.0"},
                                    {"curPos/y", "510"},
                                    {"curPos/z", "190.000"},
                                    {"curRot/pitch", "-12.5"},
                                    {"curRot/yaw", "160.0"},
                                    {"curRot/roll", "7.0"},
                                    {"PathTracer/fov", "52.0"}})
    put(std::string("unreal/camera/") + name, std::string(value));
  expect_first();
  header.dataWindow() = {{-22, 2}, {681, 397}};  // a tenth of overscan, which the field of view includes
  put("unreal/camera/PathTracer/overscanPercent", std::string("0.1"));
  truth.lens->scale_x *= 1.1;
  truth.lens->scale_y *= 1.1;
  expect_first();
}

TEST_F(HeaderCameras, KarmaAmidALargeJson) {
  std::string filler;
  for (int i = 0; i < 20000; ++i) filler += R"("prim_)" + std::to_string(i) + R"(": {"primvars": [1, 2.5, null, {"a": true}]}, )";
  put("husk:render_stats", "{" + filler + R"("camera": {"world_to_ndc": )" + listed(stored(screen())) + R"(}, "end": 1})");
  expect_first(1e-6);
  header.erase("husk:render_stats");
  const auto n = stored(screen());
  std::string rows;
  for (std::size_t r = 0; r < 4; ++r) rows += (r ? ", " : "") + listed({n.begin() + std::ptrdiff_t(4 * r), n.begin() + std::ptrdiff_t(4 * r + 4)});
  put("husk:render_stats", R"({"world_to_ndc": [)" + rows + "]}");
  expect_first(1e-6);
}

TEST_F(HeaderCameras, Nuke) {
  put("nuke/camera/matrix", listed(stored(glm::transpose(truth.world_from_camera))));
  put("nuke/camera/focal", std::to_string(0.5 * 24.576 * scale / 320));
  put("exr/nuke/camera/haperture", std::string("24.576"));
  expect_first();
}

TEST_F(HeaderCameras, HostileValuesStateNoCamera) {
  const double nan = std::nan("");
  put("cameraTransform", Matrix(nan));
  put("worldToCamera", Matrix(0.0));
  put("worldToNDC", Matrix(1e300));  // infinite in single precision
  put("rs/camera/transform", std::string("1 2 3"));
  put("nuke/camera/matrix", std::string(1 << 20, '['));
  put("unreal/camera/curPos/x", std::string("nan"));
  put("unreal/camera/curPos/y", std::string("1e999"));
  put("unreal/camera/curPos/z", std::string("z"));
  for (const std::string& json :
       {std::string("{\"world_to_ndc\": [1, 2, 3"), std::string(100000, '[') + "\"world_to_ndc\"", std::string("world_to_ndc"),
        std::string("{\"world_to_ndc\": [1e999,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}"), std::string("{\"world_to_ndc\": \"\xff\xfe\"}"),
        std::string("{\"world_to_ndc\": [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}")}) {
    header.erase("husk:render_stats");
    put("husk:render_stats", json);
    EXPECT_TRUE(header_cameras(header, display).empty()) << json.substr(0, 40);
  }
}

}  // namespace
}  // namespace relume
