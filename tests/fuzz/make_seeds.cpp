// Writes the fuzzer's seeds: the made-up scene at 12 x 12 pixels, in each renderer's names, each codec, tiled, in parts and cropped.
#include <ImfFloatAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTiledOutputPart.h>
#include <ImfVecAttribute.h>

#include <iostream>
#include <map>

#include "tests/make_gbuffer.h"

namespace {

using namespace relume;

constexpr int side = 12;  // pixels: some that are clear of edges, for the camera, and files of a few kilobytes

const Imath::M44f world_to_camera{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, float(scene_eye_z), 1};

struct SeedPart {
  std::string name, view;
  std::vector<std::string> channels;  ///< "ViewLayer.Normal.X=N.X": the name, and what of the scene it holds
};

struct Seed {
  std::string name;
  std::vector<SeedPart> parts;
  std::function<void(Imf::Header&)> edit = [](Imf::Header&) {};  ///< of the first part
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  Imf::PixelType type = Imf::FLOAT;
  int tile = 0;  ///< 0: scan lines
  Imf::LevelMode levels = Imf::ONE_LEVEL;
};

std::string name_of(const std::string& channel) { return channel.substr(0, channel.find('=')); }
std::string source_of(const std::string& channel) { return channel.substr(channel.find('=') + 1); }

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
  seeds.push_back({"whole_numbers", {{"", "", {"id=id"}}}, with_matrices, Imf::PIZ_COMPRESSION, Imf::UINT});
  return seeds;
}

/// Samples of one part, kept alive with the frame buffer that points to them.
struct Samples {
  std::vector<std::vector<float>> floats;
  std::vector<std::vector<half>> halves;
  std::vector<std::vector<unsigned>> numbers;
  Imf::FrameBuffer frame;
};

Imf::PixelType type_of(const Seed& seed, const std::string& channel) {
  return source_of(channel) == "id" && seed.type == Imf::UINT ? Imf::UINT : seed.type;
}

void fill(Samples& s, const Seed& seed, const SeedPart& part) {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(side, side);
  for (const std::string& channel : part.channels) {
    const std::string source = source_of(channel);
    const scene::Reader reader = scene::reader_of(source);
    s.floats.emplace_back();
    for (int i = 0; i < side * side; ++i) {
      const ScenePixel pixel = scene_at(made, i % side, i / side);
      s.floats.back().push_back(source == "id" ? float(pixel.id) : source == "depth" ? float(scene_eye_z - pixel.position.z) : reader(pixel));
    }
    s.halves.emplace_back(s.floats.back().begin(), s.floats.back().end());
    s.numbers.emplace_back();
    for (const float value : s.floats.back()) s.numbers.back().push_back(unsigned(std::max(value, 0.0f)));
    const Imf::PixelType type = type_of(seed, channel);
    void* const first = type == Imf::FLOAT  ? static_cast<void*>(s.floats.back().data())
                        : type == Imf::HALF ? static_cast<void*>(s.halves.back().data())
                                            : static_cast<void*>(s.numbers.back().data());
    s.frame.insert(name_of(channel), Imf::Slice::Make(type, first, {0, 0}, side, side));
  }
}

Imf::Header header_of(const Seed& seed, const SeedPart& part) {
  Imf::Header header(side, side);
  header.compression() = seed.compression;
  header.setType(seed.tile ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  if (seed.parts.size() > 1) header.setName(part.name);
  if (!part.view.empty()) header.setView(part.view);
  if (seed.tile) header.setTileDescription({unsigned(seed.tile), unsigned(seed.tile), seed.levels, Imf::ROUND_DOWN});
  for (const std::string& channel : part.channels) header.channels().insert(name_of(channel), Imf::Channel(type_of(seed, channel)));
  return header;
}

void write_tiles(Imf::MultiPartOutputFile& file, const Samples& samples) {
  Imf::TiledOutputPart out(file, 0);
  out.setFrameBuffer(samples.frame);
  for (int y = 0; y < out.numYLevels(); ++y)
    for (int x = 0; x < out.numXLevels(); ++x)
      if (out.isValidLevel(x, y)) out.writeTiles(0, out.numXTiles(x) - 1, 0, out.numYTiles(y) - 1, x, y);
}

void write(const Seed& seed, const std::filesystem::path& folder) {
  std::vector<Imf::Header> headers;
  for (const SeedPart& part : seed.parts) headers.push_back(header_of(seed, part));
  seed.edit(headers.front());
  Imf::MultiPartOutputFile file((folder / (seed.name + ".exr")).c_str(), headers.data(), int(headers.size()));
  for (std::size_t p = 0; p < seed.parts.size(); ++p) {
    Samples samples;
    fill(samples, seed, seed.parts[p]);
    if (seed.tile) {
      write_tiles(file, samples);
      continue;
    }
    Imf::OutputPart out(file, int(p));
    out.setFrameBuffer(samples.frame);
    out.writePixels(side);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_fuzz_seeds FOLDER\n";
    return 2;
  }
  for (const std::vector<Seed>& seeds : {renderers(), layouts()})
    for (const Seed& seed : seeds) write(seed, argv[1]);
}
