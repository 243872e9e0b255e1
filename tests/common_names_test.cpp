// Layers' names in words that people share, and names that speak of nothing.
#include "gbuffer/common_names.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace relume {
namespace {

TEST(CommonNames, Meanings) {
  const std::map<std::string, std::string> expected{{"WorldNormals", "normal world"},
                                                    {"normalsWorld", "normal world"},
                                                    {"world_normal", "normal world"},
                                                    {"Nrm_ws", "normal world"},
                                                    {"nrm", "normal"},
                                                    {"NormalWS", "normal world"},
                                                    {"N_camera", "normal camera"},
                                                    {"camNormal", "normal camera"},
                                                    {"bump normals", "normal"},
                                                    {"geo_normal", "base_normal"},
                                                    {"ViewLayer.Normal", "normal"},
                                                    {"position_ws", "position world"},
                                                    {"P_world", "position world"},
                                                    {"Pworld", "position world"},
                                                    {"worldpos", "position world"},
                                                    {"point_position_pass", "position"},
                                                    {"viewPos", "position camera"},
                                                    {"zDepth", "depth"},
                                                    {"ZDepth", "depth"},
                                                    {"depth.Z", "depth"},
                                                    {"hitdist", "depth distance"},
                                                    {"basecolor", "albedo"},
                                                    {"BaseColor", "albedo"},
                                                    {"diffuse_color", "albedo"},
                                                    {"Cd", "albedo"},
                                                    {"Specular_Roughness", "roughness"},
                                                    {"Metalness", "metallic"},
                                                    {"shininess", "exponent"},
                                                    {"objectId", "ids"}};
  const std::map<Says, std::string> said{{Says::nothing, ""}, {Says::world, " world"}, {Says::camera, " camera"}, {Says::distance, " distance"}};
  for (const auto& [name, meaning] : expected) {
    const auto found = meaning_of(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->role + said.at(found->says), meaning) << name;
  }
  for (const char* other : {"specular", "coat_roughness", "Pref", "tangent_normal", "object_position", "normal_variance", "light_normal",
                            "depth_normalized", "motion vector", "diffuse", "CryptoObject00", "emission", "previous position"})
    EXPECT_FALSE(meaning_of(other)) << other;
}

}  // namespace
}  // namespace relume
