// Cameras found from made-up positions: perspective off-centre with non-square pixels, orthographic, left-handed, noisy, with outliers; and where
// there is none.
#include "gbuffer/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "gbuffer/camera_plane.h"

namespace relume {
namespace {

constexpr Window display{0, 0, 640, 360};

struct MadeUp {
  Camera camera;
  double focal_x = 700, focal_y = 700, centre_x = 320, centre_y = 180;  ///< pixels; orthographic: pixels a world unit

  Sighting see(const glm::dvec3& point) const {
    const glm::dvec3 p(glm::inverse(camera.world_from_camera) * glm::dvec4(point, 1));
    const double depth = camera.projection == Camera::Projection::orthographic ? 1 : -p.z;
    return {centre_x + focal_x * p.x / depth, centre_y - focal_y * p.y / depth, point};
  }
};

Camera looking(const glm::dvec3& eye, const glm::dvec3& target) {
  Camera camera;
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
  return camera;
}

std::vector<Sighting> cloud(const MadeUp& made, int count, double thickness, double noise, double outliers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(-1, 1);
  std::normal_distribution<double> normal;
  std::vector<Sighting> sightings;
  for (int i = 0; i < count; ++i) {
    Sighting s = made.see({2 * side(random) + 5, 1.2 * side(random) - 3, thickness * side(random) + 1});
    for (int c = 0; c < 3; ++c) s.position[c] += noise * normal(random);
    if (side(random) < 2 * outliers - 1) s.position *= 0.5;
    sightings.push_back(s);
  }
  return sightings;
}

TEST(Camera, PerspectiveOffCentreNonSquare) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1}), 900, 640, 100, 300};
  const auto found = recover_camera(cloud(made, 500, 1, 0, 0), display);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->projection, Camera::Projection::perspective);
  EXPECT_LT(glm::distance(found->eye(), made.camera.eye()), 1e-8);
  for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(found->world_from_camera[c], made.camera.world_from_camera[c]), 1e-8);
  EXPECT_EQ(found->vertical_fov, 0) << "the window is off centre";
  EXPECT_LT(found->residual, 1e-6);
}

TEST(Camera, FieldOfViewOfACentredWindow) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  const auto found = recover_camera(cloud(made, 500, 1, 0, 0), display);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->vertical_fov, 2 * std::atan(180.0 / 700) * 180 / M_PI, 1e-6);
}

TEST(Camera, LeftHandedWorldIsMirrored) {
  MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  made.camera.world_from_camera[0] *= -1.0;
  const auto found = recover_camera(cloud(made, 500, 1, 0, 0), display);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::determinant(glm::dmat3(found->world_from_camera)), 0);
  EXPECT_LT(glm::distance(found->eye(), made.camera.eye()), 1e-8);
}

TEST(Camera, Orthographic) {
  MadeUp made{looking({7, -1, 9}, {5, -3, 1}), 120, 120, 320, 180};
  made.camera.projection = Camera::Projection::orthographic;
  const auto found = recover_camera(cloud(made, 500, 1, 0, 0), display);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->projection, Camera::Projection::orthographic);
  EXPECT_LT(glm::distance(found->backward(), made.camera.backward()), 1e-8);
  EXPECT_NEAR(found->height, 3, 1e-8);
}

TEST(Camera, NoiseAndOutliers) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  const auto found = recover_camera(cloud(made, 2000, 1, 1e-4, 0.1), display);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(found->eye(), made.camera.eye()), 5e-3);
  EXPECT_LT(found->residual, 0.05);
}

TEST(Camera, AThirdOfThePositionsAstray) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  auto sightings = cloud(made, 2000, 1, 0, 0);
  const auto clean = sightings;
  for (std::size_t i = 0; i < sightings.size(); i += 3) sightings[i].position = clean[(7 * i + 11) % clean.size()].position;
  const auto found = recover_camera(sightings, display);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(found->eye(), made.camera.eye()), 1e-6);
}

TEST(Camera, NearlyFlatScenesAreRefusedWhereRoundingHidesTheViewer) {
  const MadeUp made{looking({5, -3, 12}, {5, -3, 1})};
  EXPECT_TRUE(recover_camera(cloud(made, 2000, 0.01, 1e-7, 0), display));
  const Recovery hidden = recover(cloud(made, 2000, 0.01, 3e-3, 0), display);
  EXPECT_FALSE(hidden.camera);
  EXPECT_NE(hidden.why_not.find("too nearly in one plane"), std::string::npos) << hidden.why_not;
}

TEST(Camera, TheLensIsRecoveredAndTheResidualIsItsOwn) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1}), 900, 640, 100, 300};
  const auto sightings = cloud(made, 500, 1, 1e-4, 0);
  const auto found = recover_camera(sightings, display);
  ASSERT_TRUE(found && found->lens);
  EXPECT_NEAR(found->lens->scale_x, 900, 0.2);
  EXPECT_NEAR(found->lens->scale_y, 640, 0.2);
  EXPECT_NEAR(found->lens->centre_x, 100, 0.5);
  EXPECT_NEAR(found->lens->centre_y, 300, 0.5);
  EXPECT_EQ(found->residual, reprojection_error(*found, sightings));
  EXPECT_GT(found->residual, 0);
}

TEST(Camera, LensOfAFieldOfViewOrAHeight) {
  Camera camera;
  EXPECT_FALSE(lens_of(camera, display, 1)) << "nothing tells";
  camera.vertical_fov = 90;
  const Window cropped{10, 20, 650, 380};
  const auto lens = lens_of(camera, cropped, 2);
  ASSERT_TRUE(lens);
  EXPECT_NEAR(lens->scale_y, 180, 1e-9);
  EXPECT_NEAR(lens->scale_x, 90, 1e-9) << "pixels twice as wide as high";
  EXPECT_EQ(lens->centre_x, 330);
  EXPECT_EQ(lens->centre_y, 200);
  camera.projection = Camera::Projection::orthographic;
  camera.height = 3;
  EXPECT_NEAR(lens_of(camera, display, 1)->scale_y, 120, 1e-9);
}

TEST(Camera, NoneFromAPlane) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  for (const double noise : {0.0, 1e-7, 1e-4}) {
    const Recovery recovery = recover(cloud(made, 2000, 0, noise, 0), display);
    EXPECT_FALSE(recovery.camera) << "noise " << noise;
    EXPECT_NE(recovery.why_not.find("plane"), std::string::npos) << recovery.why_not;
  }
}

TEST(Camera, NoneFromTooFewOrFromNonsense) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  EXPECT_FALSE(recover_camera(cloud(made, 7, 1, 0, 0), display));
  std::vector<Sighting> nonsense = cloud(made, 500, 1, 0, 0);
  for (std::size_t i = 0; i < nonsense.size(); ++i) nonsense[i].position = nonsense[(i * 7 + 3) % nonsense.size()].position;
  EXPECT_FALSE(recover_camera(nonsense, display));
}

TEST(Camera, PoseIsJudgedWhateverTheLens) {
  const MadeUp made{looking({7, -1, 9}, {5, -3, 1}), 900, 640, 100, 300};
  const auto sightings = cloud(made, 500, 1, 0, 0);
  const PoseFit fit = fit_pose(made.camera, sightings);
  EXPECT_LT(fit.residual, 1e-9);
  EXPECT_NEAR(fit.centre_x, 100, 1e-6);
  EXPECT_NEAR(fit.scale_y, 640, 1e-6);
  Camera moved = made.camera;
  moved.world_from_camera[3] += glm::dvec4(0.1, 0, 0, 0);
  EXPECT_GT(fit_pose(moved, sightings).residual, 0.3) << "a lens may shift, but parallax stays";
  Camera behind = made.camera;
  behind.world_from_camera[2] *= -1.0;
  EXPECT_FALSE(std::isfinite(fit_pose(behind, sightings).residual));
}

TEST(Camera, APlaneTellsItWithAnOrdinaryLens) {
  MadeUp made{looking({7, -1, 9}, {5, -3, 1})};
  const std::vector<glm::dvec3> facing(2000, {0, 0, 1});
  for (const double noise : {0.0, 1e-7}) {
    const auto found = camera_of_plane(cloud(made, 2000, 0, noise, 0), facing, display, 1, {}, 1);
    ASSERT_TRUE(found) << noise;
    EXPECT_LT(glm::distance(found->eye(), made.camera.eye()), 1e-4);
    EXPECT_LT(glm::distance(found->backward(), made.camera.backward()), 1e-5);
    EXPECT_NEAR(found->lens->scale_x, 700, 0.01);
    EXPECT_TRUE(found->assumed_lens);
  }
  const std::vector<glm::dvec3> averted(2000, {0, 0, -1});
  EXPECT_FALSE(camera_of_plane(cloud(made, 2000, 0, 0, 0), averted, display, 1, {}, 1)) << "from behind, or mirrored: it does not tell";
  EXPECT_TRUE(camera_of_plane(cloud(made, 2000, 0, 0, 0), {}, display, 1, {}, 1)) << "right-handed";
}

TEST(Camera, APlaneSeenByAShiftedLensOrHeadOnNeedsTheLensItself) {
  const std::vector<glm::dvec3> facing(2000, {0, 0, 1});
  const MadeUp shifted{looking({7, -1, 9}, {5, -3, 1}), 900, 640, 100, 300};
  EXPECT_FALSE(camera_of_plane(cloud(shifted, 2000, 0, 0, 0), facing, display, 1, {}, 1));
  const auto known = camera_of_plane(cloud(shifted, 2000, 0, 0, 0), facing, display, 1, Lens{900, 640, 100, 300}, 1);
  ASSERT_TRUE(known);
  EXPECT_LT(glm::distance(known->eye(), shifted.camera.eye()), 1e-6);
  EXPECT_FALSE(known->assumed_lens);
  const MadeUp head_on{looking({5, -3, 9}, {5, -3, 1})};
  EXPECT_FALSE(camera_of_plane(cloud(head_on, 2000, 0, 1e-7, 0), facing, display, 1, {}, 1));
  EXPECT_TRUE(camera_of_plane(cloud(head_on, 2000, 0, 1e-7, 0), facing, display, 1, Lens{700, 700, 320, 180}, 1));
}

}  // namespace
}  // namespace relume
