// Headers made up with the attributes that single renderers state a camera in, against one camera known exactly.
#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>

#include "tests/header_cameras.h"

namespace relume {
namespace {

using RenderersCameras = HeaderCameras;

TEST_F(RenderersCameras, VrayOf3dsMaxAndOfMaya) {
  const Matrix y_up = truth.world_from_camera;
  put("cameraFov", degrees);
  Matrix maya = y_up;  // right, backward, down
  maya[1] = y_up[2];
  maya[2] = -y_up[1];
  put("cameraTransform", maya);
  expect_first();
  header.channels().insert("VRayNormals.X", Imf::Channel());  // one sign alone does not outweigh a level camera
  expect_first();
  forget("cameraTransform");
  truth.world_from_camera = Matrix(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1) * y_up;  // the same scene with z up
  put("cameraTransform", truth.world_from_camera);
  expect_first();
}

TEST_F(RenderersCameras, VrayLookingLevelIsToldByWhereItLooksOrByTheSceneFile) {
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

TEST_F(RenderersCameras, VrayThroughOpenImageIo) {
  Matrix maya = truth.world_from_camera;
  maya[1] = truth.world_from_camera[2];
  maya[2] = -truth.world_from_camera[1];
  put("worldToCamera", maya);
  put("cameraFov", degrees);
  put("cameraAperture", 36);
  expect_first();
}

TEST_F(RenderersCameras, Redshift) {
  Matrix transform = truth.world_from_camera;
  transform[2] *= -1.0;
  put("rs/camera/fov", degrees);
  put("rs/camera/transform", transform);
  expect_first();
  transform[0] *= -1.0;  // turned half way about y instead
  forget("rs/camera/transform");
  const auto numbers = stored(transform);
  header.insert("rs/camera/transform", Imf::FloatVectorAttribute({numbers.begin(), numbers.end()}));
  expect_first();
}

TEST_F(RenderersCameras, Unreal) {
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

TEST_F(RenderersCameras, KarmaAmidALargeJson) {
  std::string filler;
  for (int i = 0; i < 20000; ++i) filler += R"("prim_)" + std::to_string(i) + R"(": {"primvars": [1, 2.5, null, {"a": true}]}, )";
  put("husk:render_stats", "{" + filler + R"("camera": {"world_to_ndc": )" + listed(stored(screen())) + R"(}, "end": 1})");
  expect_first(1e-6);
  forget("husk:render_stats");
  const auto n = stored(screen());
  std::string rows;
  for (std::size_t r = 0; r < 4; ++r) rows += (r ? ", " : "") + listed({n.begin() + std::ptrdiff_t(4 * r), n.begin() + std::ptrdiff_t(4 * r + 4)});
  put("husk:render_stats", R"({"world_to_ndc": [)" + rows + "]}");
  expect_first(1e-6);
}

TEST_F(RenderersCameras, Nuke) {
  put("nuke/camera/matrix", listed(stored(glm::transpose(truth.world_from_camera))));
  put("nuke/camera/focal", std::to_string(0.5 * 24.576 * scale / 320));
  put("exr/nuke/camera/haperture", std::string("24.576"));
  expect_first();
}

}  // namespace
}  // namespace relume
