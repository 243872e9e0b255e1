// The fuzzer's seeds: the made-up scene at 3 x 3 pixels in each renderer's names and each header's camera, at 12 x 12 in each codec, tiled, filtered
// and ailing.
#include <ImfFloatAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>
#include <ImfVecAttribute.h>

#include <iostream>
#include <map>

#include "tests/fuzz/seed.h"
#include "tests/make_gbuffer.h"

namespace {

using namespace relume;

const Imath::M44f world_to_camera{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, float(scene_eye_z), 1};

/// Three channels: "N" from "Normal" and "XYZ".
std::vector<std::string> three(const std::string& layer, const std::string& suffixes, const std::string& source) {
  const std::string components = source == "albedo" ? "RGB" : "XYZ";
  std::vector<std::string> channels;
  for (std::size_t c = 0; c < 3; ++c) channels.push_back(layer + '.' + suffixes[c] + '=' + source + '.' + components[c]);
  return channels;
}

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <class Attribute, class Value>
auto with(const char* name, const Value& value) {
  return [=](Imf::Header& header) { header.insert(name, Attribute(value)); };
}

void with_matrices(Imf::Header& header) {
  header.insert("worldToCamera", Imf::M44fAttribute(world_to_camera));
  header.insert("worldToNDC", Imf::M44fAttribute(world_to_camera * Imath::M44f(1.37f, 0, 0, 0, 0, -1.37f, 0, 0, .5f, .5f, 1, 1, 0, 0, 0, 0)));
}

/// Generic names, for the codecs and layouts.
const std::vector<std::string> plain = three("N", "XYZ", "N") + three("P", "XYZ", "P") + std::vector<std::string>{"roughness=roughness"};

std::vector<Seed> renderers() {
  const std::vector<std::string> beauty{"R=albedo.R", "G=albedo.G", "B=albedo.B", "A=A"};
  const std::string v = "ViewLayer.";
  return {
      {"blender",
       {{"", "",
         three(v + "Normal", "XYZ", "N") + three(v + "Position", "XYZ", "P") + three(v + "DiffCol", "RGB", "albedo") +
             three(v + "GlossCol", "RGB", "albedo") + std::vector<std::string>{v + "IndexOB.X=id", v + "Depth.Z=depth", v + "rough.X=roughness"}}},
       with<Imf::StringAttribute>("BlenderMultiChannel", std::string("Blender V2.55.1 and newer"))},
      {"blender5",
       {{v + "Normal", "", three(v + "Normal", "XYZ", "N")},
        {v + "Position", "", three(v + "Position", "XYZ", "P")},
        {v + "Diffuse Color", "", three(v + "Diffuse Color", "RGB", "albedo")}}},
      {"blender_stereo",
       {{"", "",
         three(v + "Normal.left", "XYZ", "N") + three(v + "Position.left", "XYZ", "P") + three(v + "Normal.right", "XYZ", "N") +
             three(v + "Position.right", "XYZ", "P")}},
       with<Imf::StringVectorAttribute>("multiView", Imf::StringVector{"left", "right"})},
      {"mitsuba",
       {{"", "",
         three("nn", "XYZ", "N") + three("pos", "XYZ", "P") + three("geo", "XYZ", "N") + three("dpdu", "XYZ", "P") +
             std::vector<std::string>{"dd.T=depth", "shape.I=id"} + beauty}},
       with<Imf::StringAttribute>("generatedBy", std::string("Mitsuba version 3.9.1")),
       Imf::ZIP_COMPRESSION,
       Imf::HALF},
      {"pbrt",
       {{"", "",
         three("Ns", "XYZ", "N") + three("N", "XYZ", "N") + three("P", "XYZ", "P") + three("Albedo", "RGB", "albedo") +
             std::vector<std::string>{"dzdx=x", "dzdy=x", "u=x", "v=x"}}},
       [](Imf::Header& header) {
         header.insert("worldToCamera", Imf::M44fAttribute(world_to_camera.transposed()));
         header.insert("worldToNDC", Imf::M44fAttribute(world_to_camera.transposed()));
         header.insert("samplesPerPixel", Imf::IntAttribute(16));
       },
       Imf::ZIP_COMPRESSION,
       Imf::HALF},
      {"pbrt_bare", {{"", "", {"Nsx=N.X", "Nsy=N.Y", "Nsz=N.Z", "Px=P.X", "Py=P.Y", "Pz=P.Z", "dzdx=x", "dzdy=x"}}}},
      {"arnold",
       {{"", "", three("N", "XYZ", "N") + three("P", "XYZ", "P") + std::vector<std::string>{"Z=depth", "id=id"} + beauty}},
       [](Imf::Header& header) {
         with_matrices(header);
         header.insert("arnold/version", Imf::StringAttribute("7.5.0.0"));
         header.insert("arnold/aovs/N/source", Imf::StringAttribute("N"));
         header.insert("arnold/aovs/N/filter", Imf::StringAttribute("box_filter"));
       }},
      {"arnold_parts",
       {{"RGBA", "", beauty}, {"N", "", {"R=N.X", "G=N.Y", "B=N.Z"}}, {"P", "", {"R=P.X", "G=P.Y", "B=P.Z"}}},
       with<Imf::StringAttribute>("arnold/version", std::string("7.4.2"))},
      {"vray",
       {{"", "", three("VRayNormals", "XYZ", "N") + three("VRayDiffuseFilter", "RGB", "albedo") + std::vector<std::string>{"VRayZDepth.R=depth"}}},
       [](Imf::Header& header) {
         header.insert("cameraTransform", Imf::M44fAttribute(world_to_camera));
         header.insert("cameraFov", Imf::FloatAttribute(40));
       }},
      {"karma",
       {{"", "", three("N", "xyz", "N") + three("P_camera", "xyz", "P") + three("N_camera", "xyz", "N") + three("albedo", "rgb", "albedo")}},
       with<Imf::StringAttribute>("husk:render_stats", std::string(R"({"world_to_ndc": [1,0,0,0,0,1,0,0,0,0,-1,1,0,0,5,0]})"))},
      {"redshift",
       {{"",
         "",
         {"N.red=N.X", "N.green=N.Y", "N.blue=N.Z", "P.red=P.X", "P.green=P.Y", "P.blue=P.Z", "DiffuseFilter.red=albedo.R",
          "DiffuseFilter.green=albedo.G", "DiffuseFilter.blue=albedo.B"}}},
       [](Imf::Header& header) {
         header.insert("rs/camera/transform", Imf::M44fAttribute(world_to_camera));
         header.insert("rs/camera/fov", Imf::V2fAttribute({40, 40}));
       },
       Imf::RLE_COMPRESSION},
      {"unreal",
       {{"", "",
         three("FinalImageMovieRenderQueue_WorldNormal", "RGB", "N") + three("FinalImageMovieRenderQueue_WorldPosition", "RGB", "P") +
             std::vector<std::string>{"FinalImageMovieRenderQueue_WorldDepth.R=depth"} + beauty}},
       [](Imf::Header& header) {
         for (const char* key : {"pos/x", "pos/y", "pos/z", "rot/roll", "rot/pitch", "rot/yaw", "FOV"})
           header.insert((std::string("unreal/camera/curPos/") + key).c_str(), Imf::StringAttribute("1.5"));
       }},
      {"renderman",
       {{"", "", three("__Nworld", "rgb", "N") + three("__Pworld", "rgb", "P") + three("albedo", "rgb", "albedo")}},
       with_matrices,
       Imf::PXR24_COMPRESSION},
      {"delight",
       {{"", "", three("N_camera", "XYZ", "N") + three("P_camera", "XYZ", "P")}},
       [](Imf::Header& header) {
         with_matrices(header);
         header.insert("software", Imf::StringAttribute("3Delight"));
         header.insert("fieldOfViewVertical", Imf::FloatAttribute(40));
       }},
      {"nuke",
       {{"", "", {"N.red=N.X", "N.green=N.Y", "N.blue=N.Z", "depth.Z=depth"}}},
       [](Imf::Header& header) {
         header.insert("nuke/camera/haperture", Imf::FloatAttribute(24.6f));
         header.insert("nuke/camera/focal", Imf::FloatAttribute(33));
       }},
      {"cryptomatte",
       {{"", "", plain + std::vector<std::string>{"crypto00.R=x", "crypto00.G=A", "crypto00.B=x", "crypto00.A=x"}}},
       [](Imf::Header& header) {
         header.insert("cryptomatte/7a28d13/name", Imf::StringAttribute("crypto"));
         header.insert("cryptomatte/7a28d13/hash", Imf::StringAttribute("MurmurHash3_32"));
         header.insert("cryptomatte/7a28d13/conversion", Imf::StringAttribute("uint32_to_float32"));
         header.insert("cryptomatte/7a28d13/manifest", Imf::StringAttribute(R"({"ball":"3f000000","floor":"3e800000"})"));
       }}};
}

Seed with_camera(const std::string& name, const std::function<void(Imf::Header&)>& edit) {
  return {"camera_" + name, {{"", "", plain}}, edit, Imf::RLE_COMPRESSION, Imf::HALF};
}

/// Every kind of header that tells a camera, in types and spellings that the renderers' own seeds lack.
std::vector<Seed> cameras() {
  const auto texts = [](const std::map<std::string, std::string>& values) {
    return [values](Imf::Header& header) {
      for (const auto& [name, text] : values) header.insert(name.c_str(), Imf::StringAttribute(text));
    };
  };
  const auto numbers = [](const std::map<std::string, float>& values) {
    return [values](Imf::Header& header) {
      for (const auto& [name, number] : values) header.insert(name.c_str(), Imf::FloatAttribute(number));
    };
  };
  const std::string pose = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,5,1]]";
  return {
      with_camera("nuke", texts({{"nuke/camera/matrix", pose}, {"nuke/camera/focal", "33"}, {"nuke/camera/haperture", "24.6"}})),
      with_camera("karma", texts({{"husk:render_stats", R"({"camera":{"world_to_ndc":[[1,0,0,0],[0,1,0,0],[0.5,0.5,-1,-1],[2,2,5,5]]}})"}})),
      with_camera("unreal", texts({{"unreal/camera/FinalImage/fov", "40"},
                                   {"unreal/camera/FinalImage/overscanPercent", "0.1"},
                                   {"unreal/camera/curPos/x", "-500"},
                                   {"unreal/camera/curPos/y", "0"},
                                   {"unreal/camera/curPos/z", "10.5"},
                                   {"unreal/camera/curRot/pitch", "3"},
                                   {"unreal/camera/curRot/yaw", "90"}})),
      with_camera("vray_max", texts({{"cameraTransform", pose}, {"cameraFov", "40"}, {"vrayInfo/filename", "scene.max"}, {"cameraAperture", "36"}})),
      with_camera("prefixed", texts({{"exr/worldToCamera", pose}, {"nuke/exr/worldToNDC", pose}})),
      with_camera("film", numbers({{"CameraFocalLength", 50}, {"CameraFilmApertureHorizontal", 36}, {"cameraProjection", 0}})),
      with_camera("field_of_view", numbers({{"fieldOfViewHorizontal", 40}, {"fieldOfViewVertical", 40}})),
      with_camera("sensor",
                  [](Imf::Header& header) {
                    header.insert("sensorOverallDimensions", Imf::V2fAttribute({36, 24}));
                    header.insert("effectiveFocalLength", Imf::FloatAttribute(50));
                  }),
      with_camera("orthographic",
                  [](Imf::Header& header) {
                    header.insert("worldToCamera", Imf::M44dAttribute(Imath::M44d(world_to_camera)));
                    header.insert("worldToScreen", Imf::M44fAttribute(Imath::M44f(.5f, 0, 0, 0, 0, .5f, 0, 0, 0, 0, .1f, 0, 0, 0, 0, 1)));
                    header.screenWindowWidth() = 2;
                  }),
  };
}

/// What is made, taken apart and complained of.
std::vector<Seed> contents() {
  const std::function<void(Imf::Header&)> lens = with<Imf::FloatAttribute>("cameraFov", 40.0f);
  const auto cryptomattes = [](Imf::Header& header) {
    const std::pair<const char*, const char*> texts[] = {
        {"0000001/name", "CryptoObject"}, {"0000001/hash", "MurmurHash3_32"},          {"0000001/manif_file", "names.json"},
        {"0000002/name", "CryptoAsset"},  {"0000002/conversion", "uint32_to_float32"}, {"0000002/hash", "other"}};
    for (const auto& [name, text] : texts) header.insert(std::string("cryptomatte/") + name, Imf::StringAttribute(text));
    header.insert("cryptomatte/0000001/manifest", Imf::StringAttribute(R"({"b\u00e4ll":"3f000000", "/floor \n":"3F800000", "c":7, "d":"xyz"})"));
  };
  const Channels ranks{"CryptoObject00.r=x", "CryptoObject00.g=A", "CryptoObject00.b=A", "CryptoObject00.a=x",
                       "CryptoObject01.r=A", "CryptoObject01.g=x", "CryptoAsset00.R=A",  "CryptoAsset00.G=A"};
  const Channels surface = three("N", "XYZ", "N") + three("P", "XYZ", "P"), more{"Z=depth", "A=A", "id=id"};
  Seed depth{"depth_alone", {{"", "", {"Z=depth"}}}, lens}, depth_posed{"depth_posed", {{"", "", {"Z=depth", "A=A"}}}, [](Imf::Header&header) {
                                                                          header.insert("worldToCamera", Imf::M44fAttribute(world_to_camera));
                                                                          header.insert("cameraFov", Imf::FloatAttribute(40));
                                                                        }};
  Seed light{"light_over_light", {{"", "", surface + three("DiffuseLighting", "RGB", "albedo") + three("RawDiffuseLighting", "RGB", "albedo")}}};
  Seed positions{"positions_alone", {{"", "", three("P", "XYZ", "P")}}, with_matrices}, bare{"positions_bare", {{"", "", three("P", "XYZ", "P")}}};
  Seed ids{"cryptomatte_levels", {{"", "", surface + ranks}}, cryptomattes};
  Seed mean{"filtered", {{"", "", surface + more + three("albedo", "RGB", "albedo")}}, with_matrices}, hits{"filtered_pbrt", {{"", "", {}}}};
  hits.parts = {{"", "", three("Ns", "XYZ", "N") + three("N", "XYZ", "N") + three("P", "XYZ", "P") + Channels{"dzdx=x", "dzdy=x", "A=A"}}};
  Seed ailing{"ailing", {{"", "", surface + more + three("N2", "XYZ", "N") + Channels{"roughness=roughness"}}}, with_matrices};
  Seed windows{"ailing_parts", {{"N", "", three("N", "XYZ", "N")}, {"P", "", three("P", "XYZ", "P")}, {"Z", "", {"Z=depth"}}}, with_matrices};
  std::vector<Seed> seeds{depth, depth_posed, light, positions, bare, ids, mean, hits, ailing, windows};
  for (Seed& seed : seeds) {
    seed.samples = seed.name.starts_with("filtered") || seed.name.starts_with("crypto") ? 3 : 1;
    seed.ailing = seed.name.starts_with("ailing");
    seed.side = seed.samples > 1 || seed.ailing || seed.name == "positions_bare" || seed.name == "depth_posed" ? large : small;
  }
  return seeds;
}

/// Codecs, tiles and types, under plain names.
std::vector<Seed> layouts() {
  std::vector<Seed> seeds;
  const std::map<std::string, Imf::Compression> codecs{
      {"none", Imf::NO_COMPRESSION},   {"rle", Imf::RLE_COMPRESSION},     {"zips", Imf::ZIPS_COMPRESSION},
      {"piz", Imf::PIZ_COMPRESSION},   {"pxr24", Imf::PXR24_COMPRESSION}, {"b44", Imf::B44_COMPRESSION},
      {"b44a", Imf::B44A_COMPRESSION}, {"dwaa", Imf::DWAA_COMPRESSION},   {"dwab", Imf::DWAB_COMPRESSION}};
  for (const auto& [name, codec] : codecs)
    seeds.push_back({"codec_" + name, {{"", "", plain}}, with_matrices, codec, name == "b44" || name == "b44a" ? Imf::HALF : Imf::FLOAT});
  seeds.push_back({"tiles", {{"", "", plain}}, with_matrices, Imf::ZIP_COMPRESSION, Imf::HALF, 8});
  seeds.push_back({"mipmap", {{"", "", plain}}, with_matrices, Imf::PIZ_COMPRESSION, Imf::HALF, 5, Imf::MIPMAP_LEVELS});
  seeds.push_back({"ripmap", {{"", "", plain}}, with_matrices, Imf::RLE_COMPRESSION, Imf::HALF, 7, Imf::RIPMAP_LEVELS});
  for (Seed& seed : seeds) seed.side = large;
  seeds.push_back({"whole_numbers", {{"", "", {"id=id"}}}, with_matrices, Imf::PIZ_COMPRESSION, Imf::UINT});
  return seeds;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_fuzz_seeds FOLDER\n";
    return 2;
  }
  for (const std::vector<Seed>& seeds : {renderers(), cameras(), contents(), layouts()})
    for (const Seed& seed : seeds) write(seed, argv[1]);
}
