// Channel names of many renderers taken apart.
#include "gbuffer/layers.h"

#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/made_up_exr.h"

namespace relume {
namespace {

double zero(const std::string&, int, int) { return 0; }

void blender(Imf::Header& header) { header.insert("BlenderMultiChannel", Imf::StringAttribute("Blender V2.55.1 and newer")); }

void stereo(Imf::Header& header) { header.insert("multiView", Imf::StringVectorAttribute({"left", "right"})); }

std::vector<Layer> layers_in(const std::vector<MadeUpPart>& parts, const MadeUpExr::Edit& edit = {}) {
  const MadeUpExr made(parts, 2, 2, zero, edit);
  return layers_of(ExrFile(made.file));
}

const Layer* find(const std::vector<Layer>& layers, const std::string& view_layer, const std::string& name, const std::string& view = "") {
  const auto found =
      std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.view_layer == view_layer && l.name == name && l.view == view; });
  return found == layers.end() ? nullptr : &*found;
}

TEST(Layers, BlenderNamesWithSpacesAndDots) {
  const auto layers =
      layers_in({{"",
                  "",
                  {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Base Color.R", "ViewLayer.001.Combined.R",
                   "ViewLayer.001.Normal.X", "ViewLayer.001.Normal.Y", "ViewLayer.001.Normal.Z", "Set only.Depth.Z"}}},
                blender);
  EXPECT_TRUE(find(layers, "ViewLayer", "Base Color"));
  EXPECT_TRUE(find(layers, "Set only", "Depth"));
  const Layer* const normal = find(layers, "ViewLayer.001", "Normal");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->triple(), (std::vector<std::string>{"ViewLayer.001.Normal.X", "ViewLayer.001.Normal.Y", "ViewLayer.001.Normal.Z"}));
  EXPECT_EQ(layers.size(), 5u);
}

TEST(Layers, BlenderStereoInOnePart) {
  const auto layers =
      layers_in({{"", "", {"ViewLayer.Combined.left.R", "ViewLayer.Combined.right.R", "ViewLayer.Depth.left.Z", "ViewLayer.Depth.right.Z"}}}, stereo);
  EXPECT_TRUE(find(layers, "ViewLayer", "Combined", "left"));
  EXPECT_TRUE(find(layers, "ViewLayer", "Depth", "right"));
  EXPECT_EQ(layers.size(), 4u);
}

TEST(Layers, BlenderFiveInManyParts) {
  const auto layers = layers_in(
      {{"ViewLayer.Combined-left", "left", {"ViewLayer.Combined.R"}}, {"ViewLayer.Normal-right", "right", {"ViewLayer.Normal.X"}}}, blender);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_TRUE(find(layers, "ViewLayer", "Combined", "left"));
  const Layer* const normal = find(layers, "ViewLayer", "Normal", "right");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->part, 1);
}

TEST(Layers, PartsOfArnoldAreLayers) {
  const auto layers = layers_in({{"RGBA", "", {"R", "G", "B", "A"}}, {"N", "", {"X", "Y", "Z"}}, {"roughness", "", {"roughness"}}, {"Z", "", {"Z"}}});
  ASSERT_TRUE(find(layers, "", ""));
  EXPECT_TRUE(find(layers, "", "")->component('a'));
  ASSERT_TRUE(find(layers, "", "N"));
  EXPECT_EQ(find(layers, "", "N")->triple().size(), 3u);
  ASSERT_TRUE(find(layers, "", "roughness"));
  EXPECT_TRUE(find(layers, "", "roughness")->component('\0'));
  ASSERT_TRUE(find(layers, "", "Z"));
  EXPECT_TRUE(find(layers, "", "Z")->component('\0'));
}

TEST(Layers, BareAndOddComponents) {
  const auto layers = layers_in(
      {{"", "", {"R", "G", "B", "Z", "dzdx", "Nsx", "N.red", "N.green", "N.blue", "P.x", "hitdist.hitdist", "prim.id", "a.b.unknown", "dd.y.T"}}});
  ASSERT_TRUE(find(layers, "", ""));
  EXPECT_EQ(find(layers, "", "")->triple(), (std::vector<std::string>{"R", "G", "B"}));
  for (const char* bare : {"Z", "dzdx", "Nsx", "hitdist", "a.b.unknown"}) {
    ASSERT_TRUE(find(layers, "", bare)) << bare;
    EXPECT_TRUE(find(layers, "", bare)->component('\0')) << bare;
  }
  ASSERT_TRUE(find(layers, "", "N"));
  EXPECT_EQ(find(layers, "", "N")->triple(), (std::vector<std::string>{"N.red", "N.green", "N.blue"}));
  EXPECT_TRUE(find(layers, "", "P")->component('x'));
  EXPECT_TRUE(find(layers, "", "prim")->component('i'));
  EXPECT_TRUE(find(layers, "", "dd.y")->component('t'));
}

TEST(Layers, BareVectorsAreOneLayer) {
  const auto layers =
      layers_in({{"", "", {"Nsx", "Nsy", "Nsz", "NX", "NY", "NZ", "normal_r", "normal_g", "normal_b", "u", "v", "dzdx", "dzdy", "Z"}}});
  const auto triple = [&](const char* name) {
    const Layer* const layer = find(layers, "", name);
    return layer ? layer->triple() : std::vector<std::string>{};
  };
  EXPECT_EQ(triple("Ns"), (std::vector<std::string>{"Nsx", "Nsy", "Nsz"}));
  EXPECT_EQ(triple("N"), (std::vector<std::string>{"NX", "NY", "NZ"}));
  EXPECT_EQ(triple("normal"), (std::vector<std::string>{"normal_r", "normal_g", "normal_b"}));
  ASSERT_TRUE(find(layers, "", "uv"));
  EXPECT_TRUE(find(layers, "", "uv")->component('v'));
  EXPECT_TRUE(find(layers, "", "dzdx")->component('\0'));
  EXPECT_EQ(layers.size(), 7u);
}

TEST(Layers, DotsOfOthersAreNoViewLayers) {
  const auto layers = layers_in({{"", "", {"N.world.X", "N.world.Y", "N.world.Z"}}});
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].name, "N.world");
  EXPECT_EQ(layers[0].view_layer, "");
}

TEST(Layers, Normalised) { EXPECT_EQ(normalised("__Diffuse Col-or_2"), "diffusecolor2"); }

}  // namespace
}  // namespace relume
