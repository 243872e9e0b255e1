// Headers made up with matrices and fields of view as many programs have them, in every attribute type, against one camera known exactly.
#include "gbuffer/camera_header.h"

#include <ImfDoubleAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>

#include "tests/header_cameras.h"

namespace relume {
namespace {

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
  forget("worldToNDC");
  put("worldToScreen", screen());
  expect_first();
}

TEST_F(HeaderCameras, AProjectionAlone) {
  put("worldToNDC", ndc());
  expect_first(1e-4);
  forget("worldToNDC");
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
  forget("worldToNDC");
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
  forget("worldToCamera");
  header.insert("worldToCamera", Imf::M44dAttribute(matrix));
  expect_first();
}

TEST_F(HeaderCameras, FieldsOfView) {
  put("worldToCamera", camera_from_world());
  put("fieldOfViewHorizontal", degrees);
  expect_first();
  forget("fieldOfViewHorizontal");
  put("fieldOfViewVertical", 2 * std::atan(180 / scale) * 180 / M_PI);
  expect_first();
  forget("fieldOfViewVertical");
  header.insert("CameraFov", Imf::IntAttribute(int(degrees)));
  expect_first();
  forget("CameraFov");
  put("focal", 0.5 * 36 * scale / 320);
  put("haperture", 36);
  expect_first();
  forget("focal");
  put("nominalFocalLength", 0.5 * 36 * scale / 320);
  header.insert("sensorOverallDimensions", Imf::V2fAttribute({36, 20.25f}));
  expect_first();
  forget("sensorOverallDimensions");
  header.screenWindowWidth() = float(640 / scale);
  expect_first();
  header.screenWindowWidth() = 1;
  truth.lens.reset();
  expect_first();
}

TEST_F(HeaderCameras, OpenGlsViewAndTheCamerasOwnTransform) {
  put("worldToCamera", glm::inverse(truth.world_from_camera));
  expect_among();
  forget("worldToCamera");
  put("worldToCamera", truth.world_from_camera);
  expect_among();
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
    forget("husk:render_stats");
    put("husk:render_stats", json);
    EXPECT_TRUE(header_cameras(header, display).empty()) << json.substr(0, 40);
  }
}

}  // namespace
}  // namespace relume
