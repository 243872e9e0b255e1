// relume directions: what the lecture says of n, v, l, R_v, R_l and h, seen in the layers that the program writes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/picture.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

class Directions : public testing::Test {
 protected:
  void SetUp() override {
    write_gbuffer(in("in.exr"), MadeUpGBuffer::of_size(37, 29));
    std::ofstream(in("rig.json")) << R"({"relume": 1, "lights": [{"type": "point", "name": "key", "position": [2, 3, 4], "intensity": [1, 1, 1]},
      {"type": "directional", "name": "sun", "direction": [0, -2, 0], "intensity": [1, 1, 1]}, {"type": "ambient", "name": "all", "intensity": [1, 1, 1]}]})";
  }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  ProgramRun run(const std::string& output, std::vector<std::string> options) const {
    options.insert(options.begin(), {"directions", in("in.exr"), "-o", in(output), "--quiet"});
    return run_program(options);
  }
  Channels layers(const std::string& output, const std::vector<std::string>& options) const {
    const ProgramRun result = run(output, options);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? read_channels(in(output)) : Channels{};
  }

 private:
  TemporaryFolder folder_;
};

glm::dvec3 vector_at(const Channels& layers, const std::string& name, std::size_t i) {
  return {layers.at(name + ".X")[i], layers.at(name + ".Y")[i], layers.at(name + ".Z")[i]};
}

TEST_F(Directions, AreThoseOfTheLecture) {
  const Channels layers = this->layers("out.exr", {"--lights", in("rig.json"), "--light", "key"});
  const MadeUpGBuffer made = MadeUpGBuffer::of_size(37, 29);
  int shown = 0;
  for (int y = 0; y < 29; ++y)
    for (int x = 0; x < 37; ++x) {
      const auto i = std::size_t(y * 37 + x);
      const ScenePixel pixel = scene_at(made, x, y);
      const auto near = [&](const char* name, const glm::dvec3& expected) {
        EXPECT_LT(glm::length(vector_at(layers, name, i) - expected), 2e-6) << name << " at " << x << "," << y;
      };
      const auto cosine = [&](const char* name, double expected) {
        EXPECT_NEAR(layers.at(std::string("cosine.") + name)[i], expected, 2e-6) << name;
      };
      if (pixel.id == 0) {
        for (const auto& [channel, values] : layers) EXPECT_EQ(values[i], 0) << channel;
        continue;
      }
      ++shown;
      const glm::dvec3 n = pixel.normal, v = glm::normalize(glm::dvec3(0, 0, scene_eye_z) - pixel.position),
                       l = glm::normalize(glm::dvec3(2, 3, 4) - pixel.position), h = glm::normalize(l + v);
      near("n", n), near("v", v), near("l", l), near("h", h);
      near("R_v", 2 * glm::dot(n, v) * n - v), near("R_l", 2 * glm::dot(n, l) * n - l);
      cosine("n_l", glm::dot(n, l)), cosine("n_v", glm::dot(n, v)), cosine("l_v", glm::dot(l, v)), cosine("n_h", glm::dot(n, h));
      cosine("v_h", glm::dot(v, h)), cosine("R_v_l", glm::dot(2 * glm::dot(n, v) * n - v, l));
    }
  EXPECT_GT(shown, 300);
}

TEST_F(Directions, OfAPointNeedNoRig) {
  const Channels named = layers("named.exr", {"--lights", in("rig.json"), "--light", "key"}), placed = layers("placed.exr", {"--light", "2,3,4"});
  EXPECT_EQ(named, placed);
}

TEST_F(Directions, AreTheSameOnTheTwin) {
  EXPECT_EQ(layers("device.exr", {"--light", "2,3,4"}), layers("twin.exr", {"--light", "2,3,4", "--device", "twin"}));
}

TEST_F(Directions, OfADirectionalLightAreTheSameEverywhere) {
  const Channels layers = this->layers("out.exr", {"--lights", in("rig.json"), "--light", "sun"});
  for (std::size_t i = 0; i < layers.at("l.Y").size(); ++i) {
    EXPECT_TRUE(layers.at("l.Y")[i] == 1 || layers.at("n.Z")[i] == 0);
  }
}

TEST_F(Directions, ComeWithAPicture) {
  EXPECT_EQ(run("out.exr", {"--light", "2,3,4", "--png", in("out.png")}).code, 0);
  const Picture sheet = read_picture(in("out.png"));
  EXPECT_GT(sheet.width, 3 * 37);
  EXPECT_GT(sheet.height, 4 * 29);
}

TEST_F(Directions, RefuseInOneLine) {
  const auto refused = [&](std::vector<std::string> options, const std::string& words) {
    const ProgramRun result = run("no.exr", std::move(options));
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(in("no.exr")));
  };
  refused({"--lights", in("rig.json"), "--light", "fill"}, "fill: no such light (has: key, sun");
  refused({"--lights", in("rig.json")}, "--light is needed");
  refused({"--lights", in("rig.json"), "--light", "all"}, "no such light");
  refused({"--light", "1e300,0,0"}, "beyond single precision");
  refused({}, "no light that comes from a direction");
}

}  // namespace
}  // namespace relume
