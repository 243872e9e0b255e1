// A live frame after any changes has the bits of one that was made with the lights as they are now, and shades only what a change reaches.
#include "host/live_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gbuffer/error.h"
#include "host/camera_choice.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

Light light_at(const glm::dvec3& position, double range = 0) {
  Light light;
  light.name = "light";
  light.position = position;
  light.intensity = {9, 8, 7};
  light.range = range;
  light.falloff = range > 0 ? Falloff::windowed : Falloff::inverse_square;
  return light;
}

std::vector<Light> five_lights() {
  Light sun = light_at({});
  sun.type = LightType::directional;
  sun.direction = glm::normalize(glm::dvec3(1, -2, -1));
  sun.intensity = {0.5, 0.4, 0.3};
  Light ambient = sun;
  ambient.type = LightType::ambient;
  Light spot = light_at({-2, 3, 2});
  spot.type = LightType::spot;
  spot.direction = glm::normalize(glm::dvec3(2, -3, -2));
  return {light_at({2, 3, 4}), sun, ambient, light_at({0.5, 0.2, 1.2}, 0.6), spot};
}

/// A frame of two programs in memory, and all that a live frame refers to.
class Scene {
 public:
  explicit Scene(const std::string& device) : device_(open_device(device)) {
    MadeUpGBuffer made = MadeUpGBuffer::of_size(150, 90);
    made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "A", "id"});
    write_gbuffer(folder_ / "in.exr", made);
    file_.emplace(folder_ / "in.exr");
    std::vector<Rig> no_rigs;
    reading_ = understand_with_rigs(*file_, {}, no_rigs);
    Material shiny;
    shiny.diffuse = "lambert";
    shiny.specular = "cook_torrance";
    MaterialFile materials;
    materials.by_id[1] = shiny;
    materials.fallback = Material{"oren_nayar", "none", {}, {}, {}, {}, {}};
    materials.objects.emplace(*file_, reading_, "id", false);
    binding_.emplace(
        Material{}, materials, "in.exr", [this](const std::string& layer) { return find_layer(*file_, reading_, layer); }, reading_);
  }
  LiveFrame frame() {
    GBuffer gbuffer = read_gbuffer(*file_, reading_, reading_.data_window, binding_->roles(), binding_->spare_planes());
    return {*device_, std::move(gbuffer), *binding_, reading_};
  }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Device> device_;
  std::optional<ExrFile> file_;
  Reading reading_;
  std::optional<Binding> binding_;
};

int differences(const LiveFrame& a, const LiveFrame& b) {
  int count = 0;
  for (int plane = 0; plane < 3; ++plane)
    for (std::int64_t i = 0; i < a.window().pixels(); ++i) count += a.radiance().plane(plane)[i] != b.radiance().plane(plane)[i];
  return count;
}

double brightest(const LiveFrame& frame) { return *std::max_element(frame.radiance().plane(0), frame.radiance().plane(0) + frame.window().pixels()); }

class LiveFrames : public testing::TestWithParam<const char*> {};

TEST_P(LiveFrames, DoNotDrift) {
  Scene scene(GetParam());
  LiveFrame dragged = scene.frame(), fresh = scene.frame();
  std::vector<Light> lights = five_lights();
  dragged.set_lights(lights);
  std::mt19937 random(3);
  std::uniform_real_distribution<> in(-2, 2);
  for (const std::size_t number : {0u, 3u, 4u, 1u, 3u})
    for (int step = 0; step < 6; ++step) {
      lights[number].position = {in(random), in(random), in(random) + 2};
      lights[number].intensity = {in(random) + 3, 1, in(random) + 3};
      dragged.change_light(number, lights[number]);
    }
  fresh.set_lights(lights);
  fresh.change_light(3, lights[3]);
  EXPECT_EQ(differences(dragged, fresh), 0);
  EXPECT_GT(brightest(fresh), 0.1);
}

TEST_P(LiveFrames, HoldingTheLastLightHaveTheBitsOfShadingAll) {
  Scene scene(GetParam());
  LiveFrame dragged = scene.frame(), brute = scene.frame();
  std::vector<Light> lights = five_lights();
  dragged.set_lights(lights);
  lights[4].position.x = 1;  // the spot: kernels take it last
  dragged.change_light(4, lights[4]);
  lights[4].position.y = 2;
  dragged.change_light(4, lights[4]);
  brute.set_lights(lights);
  EXPECT_EQ(differences(dragged, brute), 0);
}

TEST_P(LiveFrames, HoldingAnotherLightDifferByRoundingAlone) {
  Scene scene(GetParam());
  LiveFrame dragged = scene.frame(), brute = scene.frame();
  std::vector<Light> lights = five_lights();
  dragged.set_lights(lights);
  lights[0].position.x = 1;
  dragged.change_light(0, lights[0]);
  brute.set_lights(lights);
  for (int plane = 0; plane < 3; ++plane)
    for (std::int64_t i = 0; i < brute.window().pixels(); ++i)
      ASSERT_NEAR(dragged.radiance().plane(plane)[i], brute.radiance().plane(plane)[i], 1e-6 * (1 + brute.radiance().plane(plane)[i]));
}

TEST_P(LiveFrames, ShadeWhatARangeReaches) {
  Scene scene(GetParam());
  LiveFrame dragged = scene.frame(), fresh = scene.frame();
  std::vector<Light> lights = five_lights();
  dragged.set_lights(lights);
  dragged.change_light(3, lights[3]);
  EXPECT_EQ(dragged.touched(), 1);  // it is held from here on
  lights[3].position = {-0.6, -0.2, 1.2};
  dragged.change_light(3, lights[3]);
  EXPECT_GT(dragged.touched(), 0);
  EXPECT_LT(dragged.touched(), 0.5);
  fresh.set_lights(lights);
  fresh.change_light(3, lights[3]);
  EXPECT_EQ(differences(dragged, fresh), 0);
}

/// Seven lights are met by all pixels, fourteen by those that they reach.
TEST_P(LiveFrames, OfManyRangedLightsAreTheSumOfFew) {
  Scene scene(GetParam());
  LiveFrame all = scene.frame(), some = scene.frame(), others = scene.frame();
  std::vector<Light> lights;
  for (int k = 0; k < 14; ++k) lights.push_back(light_at({std::sin(2.1 * k), std::cos(1.3 * k), 1 + 0.5 * std::sin(0.7 * k)}, 0.4 + 0.1 * k));
  all.set_lights(lights);
  some.set_lights({lights.begin(), lights.begin() + 7});
  others.set_lights({lights.begin() + 7, lights.end()});
  for (int plane = 0; plane < 3; ++plane)
    for (std::int64_t i = 0; i < all.window().pixels(); ++i) {
      const float sum = some.radiance().plane(plane)[i] + others.radiance().plane(plane)[i];
      ASSERT_NEAR(all.radiance().plane(plane)[i], sum, 1e-5 * (1 + sum));
    }
  EXPECT_GT(brightest(all), 0.1);
}

TEST_P(LiveFrames, TakeAnyChange) {
  Scene scene(GetParam());
  LiveFrame changed = scene.frame(), fresh = scene.frame();
  std::vector<Light> lights = five_lights();
  changed.set_lights(lights);
  lights[2].intensity = {0.1, 0.2, 0.3};
  changed.change_light(2, lights[2]);  // ambient
  lights[0] = five_lights()[1];
  changed.change_light(0, lights[0]);  // a point becomes a sun
  fresh.set_lights(lights);
  fresh.change_light(0, lights[0]);
  EXPECT_EQ(differences(changed, fresh), 0);
}

INSTANTIATE_TEST_SUITE_P(Devices, LiveFrames, testing::Values("twin", ""), [](const auto& info) { return *info.param ? "twin" : "best"; });

TEST(LiveFrame, RefusesWhatItDoesNotKnow) {
  Scene scene("twin");
  LiveFrame frame = scene.frame();
  std::vector<Light> lights = five_lights();
  frame.set_lights(lights);
  EXPECT_THROW(frame.change_light(5, lights[0]), Error);
  lights[0].include = {"1"};
  EXPECT_THROW(frame.change_light(0, lights[0]), Error);
  EXPECT_THROW(frame.set_lights(lights), Error);
}

}  // namespace
}  // namespace relume
