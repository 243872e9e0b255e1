// relume doctor: each ailment in a made-up file that has exactly it, with count, box, example pixel and exit code; and the files that have none.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/made_up_exr.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

using Json = nlohmann::json;

MadeUpGBuffer healthy() {
  MadeUpGBuffer made;
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A", "id"});
  return made;
}

struct Doctored {
  int code;
  Json json;
  std::string err;

  /// The findings of one ailment.
  std::vector<Json> of(const std::string& ailment) const {
    std::vector<Json> found;
    for (const Json& f : json["findings"])
      if (f["ailment"] == ailment) found.push_back(f);
    return found;
  }
  std::string defects() const {
    std::string names;
    for (const Json& f : json["findings"])
      if (f["severity"] == "defect") names += f["ailment"].get<std::string>() + " ";
    return names;
  }
};

Doctored doctored(const std::filesystem::path& file, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"doctor", file.string(), "--json"});
  const ProgramRun run = run_program(more);
  return {run.code, Json::parse(run.out, nullptr, false), run.err};
}

Doctored doctored(const MadeUpGBuffer& made, const std::vector<std::string>& more = {}) {
  const TemporaryFolder folder;
  write_gbuffer(folder / "made.exr", made);
  return doctored(folder / "made.exr", more);
}

/// Four pixels of the sphere, in the middle of the frame: columns 30..31, rows 33..34.
bool in_patch(int x, int y) { return x >= 30 && x < 32 && y >= 33 && y < 35; }

void expect_patch(const Doctored& d, const std::string& ailment, const std::string& severity) {
  ASSERT_EQ(d.of(ailment).size(), 1u) << d.json.dump(1) << d.err;
  const Json f = d.of(ailment).front();
  EXPECT_EQ(f["severity"], severity);
  EXPECT_EQ(f["pixels"], 4);
  EXPECT_EQ(f["box"], Json({{"x0", 30}, {"y0", 33}, {"x1", 32}, {"y1", 35}}));
  EXPECT_TRUE(in_patch(f["example"]["x"], f["example"]["y"])) << f.dump();
  EXPECT_FALSE(f["what"].get<std::string>().empty());
  EXPECT_FALSE(f["effect"].get<std::string>().empty());
  EXPECT_EQ(d.code, severity == "defect" ? 1 : 0);
}

/// A healthy file but for what `change` does to the patch.
Doctored with_patch(const std::function<void(ScenePixel&)>& change) {
  MadeUpGBuffer made = healthy();
  made.pixel = [change](int x, int y, ScenePixel& pixel) {
    if (in_patch(x, y)) change(pixel);
  };
  return doctored(made);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

TEST(Doctor, HealthyFileHasNoDefect) {
  for (const bool half : {false, true}) {
    MadeUpGBuffer made = healthy();
    made.half = half;
    const Doctored d = doctored(made);
    EXPECT_EQ(d.code, 0);
    EXPECT_EQ(d.defects(), "") << d.json.dump(1);
    EXPECT_TRUE(d.json["understood"]);
  }
}

TEST(Doctor, NotFinite) {
  const Doctored d = with_patch([](ScenePixel& p) { p.albedo.y = nan; });
  expect_patch(d, "not_finite", "defect");
  EXPECT_EQ(d.of("not_finite")[0]["layer"], "albedo");
  EXPECT_EQ(d.of("not_finite")[0]["example"], Json({{"x", 30}, {"y", 33}}));
  expect_patch(with_patch([](ScenePixel& p) { p.position.x = infinity; }), "not_finite", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.normal.z = -infinity; }), "not_finite", "defect");
}

TEST(Doctor, InfiniteBackgroundIsNone) {
  MadeUpGBuffer made = healthy();
  made.pixel = [](int, int, ScenePixel& pixel) {
    if (pixel.id == 0) pixel.position = {infinity, infinity, infinity};
  };
  EXPECT_EQ(doctored(made).defects(), "");
}

TEST(Doctor, ZeroNormals) {
  expect_patch(with_patch([](ScenePixel& p) { p.normal = {0, 0, 0}; }), "zero_normals", "defect");
}

TEST(Doctor, LongNormals) {
  expect_patch(with_patch([](ScenePixel& p) { p.normal *= 3; }), "long_normals", "hint");
}

TEST(Doctor, AvertedNormals) {
  const auto flip = [](ScenePixel& p) { p.normal *= -1; };
  expect_patch(with_patch(flip), "averted_normals", "defect");
  MadeUpGBuffer made = healthy();
  made.pixel = [&](int x, int y, ScenePixel& p) {
    if (in_patch(x, y)) flip(p);
  };
  EXPECT_EQ(doctored(made, {"--facing", "two-sided"}).code, 0);
}

TEST(Doctor, NormalsInAnotherSpace) {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(256, 256);
  made.pixel = [](int, int, ScenePixel& p) { p.normal = {p.normal.z, p.normal.x, p.normal.y}; };
  const Doctored d = doctored(made, {"--normal-space", "world", "--normal-axes", "x,y,z"});
  ASSERT_EQ(d.of("misplaced_normals").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("misplaced_normals")[0]["severity"], "defect");
  EXPECT_GT(d.of("misplaced_normals")[0]["pixels"], 1000);
  EXPECT_EQ(d.code, 1);
  made.pixel = nullptr;
  EXPECT_TRUE(doctored(made).of("misplaced_normals").empty());
}

TEST(Doctor, FarPositions) {
  MadeUpGBuffer made = healthy();
  made.pixel = [](int x, int y, ScenePixel& p) {
    if (in_patch(x, y)) p.position *= 1e30;
  };
  const Doctored d = doctored(made);
  ASSERT_EQ(d.of("far_positions").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("far_positions")[0]["pixels"], 4);
  EXPECT_EQ(d.code, 1);
}

TEST(Doctor, HalfPositionsUnderANearLight) {
  const TemporaryFolder folder;
  const auto rig = [&](const glm::dvec3& p) {
    std::ofstream(folder / "rig.json") << R"({"relume": 1, "lights": [{"type": "point", "intensity": [1, 1, 1], "position": [)" << p.x << ',' << p.y
                                       << ',' << p.z << "]}]}";
    return std::vector<std::string>{"--lights", (folder / "rig.json").string()};
  };
  MadeUpGBuffer made = healthy();
  made.half = true;
  EXPECT_EQ(doctored(made, rig({0, 0, 9})).code, 0);  // 8 units away: 0.0005 of rounding does not show
  // On the surface, at a pixel's own place; the next pixel is a hundred roundings away.
  const std::vector<std::string> near = rig(scene_at(made, 32, 32).position);
  const Doctored d = doctored(made, near);
  ASSERT_EQ(d.of("coarse_positions").size(), 1u) << d.json.dump(1);
  const Json f = d.of("coarse_positions")[0];
  EXPECT_EQ(f["severity"], "defect");
  EXPECT_EQ(f["pixels"], 1);
  EXPECT_EQ(f["box"], Json({{"x0", 32}, {"y0", 32}, {"x1", 33}, {"y1", 33}}));
  EXPECT_EQ(f["example"], Json({{"x", 32}, {"y", 32}}));
  EXPECT_EQ(d.code, 1);
  made.half = false;
  EXPECT_EQ(doctored(made, rig(scene_at(made, 32, 32).position + glm::dvec3(0, 0, 0.01))).code, 0);
}

TEST(Doctor, DepthThatContradictsPositions) {
  // "depth" is 0.5 in the made-up scene unless a value is given for it: a file of its own.
  const auto value = [](bool wrong, bool distance) {
    return [=](const std::string& channel, int x, int y) -> double {
      const MadeUpGBuffer made;
      const ScenePixel p = scene_at(made, x, y);
      const double z = scene_eye_z - p.position.z;
      if (channel == "Z" && p.id == 0) return 1e10;
      if (channel == "Z") return (distance ? glm::length(p.position - glm::dvec3(0, 0, scene_eye_z)) : z) * (wrong && in_patch(x, y) ? 1.5 : 1);
      return double(scene::reader_of(channel)(p));
    };
  };
  const std::vector<MadeUpPart> parts{{"", "", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "Z"}}};
  const auto camera = [](Imf::Header& h) {
    h.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, float(scene_eye_z), 1}));
  };
  for (const bool distance : {false, true}) {
    const MadeUpExr right(parts, 64, 64, value(false, distance), camera), wrong(parts, 64, 64, value(true, distance), camera);
    EXPECT_EQ(doctored(right.file).defects(), "");
    expect_patch(doctored(wrong.file), "contradicting_depth", "defect");
  }
}

TEST(Doctor, OutOfRange) {
  expect_patch(with_patch([](ScenePixel& p) { p.albedo.x = -0.5; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.albedo.x = 1.5; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.roughness = 1.2; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.metallic = -1; }), "out_of_range", "defect");
}

/// A float (or uint) id layer with this value in the patch and 1 elsewhere.
Doctored with_ids(const std::string& channel, double value) {
  const MadeUpExr file({{"", "", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", channel}}}, 64, 64, [=](const std::string& c, int x, int y) {
    return c == "id" ? (in_patch(x, y) ? value : 1.0) : double(scene::reader_of(c)(scene_at(MadeUpGBuffer(), x, y)));
  });
  return doctored(file.file);
}

TEST(Doctor, Ids) {
  expect_patch(with_ids("id", 16777218.0), "ids", "defect");
  expect_patch(with_ids("id", 1e-44), "ids", "defect");  // 7 as a whole number
  expect_patch(with_ids("id", 1.5), "ids", "hint");
  expect_patch(with_ids("id:uint", 4294967295.0), "ids", "hint");
  EXPECT_TRUE(with_ids("id", 7).of("ids").empty());
}

TEST(Doctor, MixedPixels) {
  const Doctored d = with_patch([](ScenePixel& p) { p.normal *= 0.8; });
  expect_patch(d, "mixed_pixels", "hint");
  expect_patch(with_patch([](ScenePixel& p) { p.alpha = 0.5; }), "mixed_pixels", "hint");
}

TEST(Doctor, Camera) {
  MadeUpGBuffer made = healthy();
  made.camera_in_header = false;
  const Doctored recovered = doctored(made);
  ASSERT_EQ(recovered.of("camera").size(), 1u);
  EXPECT_EQ(recovered.of("camera")[0]["severity"], "hint");
  made.header = [](Imf::Header& header) {  // stands aside from where the scene was seen
    header.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 3, 0, float(scene_eye_z), 1}));
  };
  const Doctored contradicted = doctored(made);
  ASSERT_EQ(contradicted.of("camera").size(), 1u) << contradicted.json.dump(1);
  EXPECT_EQ(contradicted.of("camera")[0]["severity"], "defect");
  EXPECT_EQ(contradicted.code, 1);
}

TEST(Doctor, LossyCodec) {
  MadeUpGBuffer made = healthy();
  made.half = true;
  for (const auto& [codec, layers] :
       {std::pair(Imf::DWAA_COMPRESSION, 2), {Imf::B44_COMPRESSION, 2}, {Imf::PIZ_COMPRESSION, 0}, {Imf::PXR24_COMPRESSION, 0}}) {
    made.compression = codec;
    const Doctored d = doctored(made);
    EXPECT_EQ(int(d.of("lossy_codec").size()), layers) << codec;  // N and P
    EXPECT_EQ(d.defects().find("lossy_codec") != std::string::npos, layers > 0) << codec;
  }
  made.half = false;
  made.compression = Imf::PXR24_COMPRESSION;
  EXPECT_EQ(doctored(made).of("lossy_codec").size(), 2u);
  EXPECT_EQ(doctored(made).code, 0);
}

TEST(Doctor, Windows) {
  MadeUpGBuffer made = healthy();
  made.data = {100, 100, 164, 164};
  const Doctored outside = doctored(made);
  ASSERT_EQ(outside.of("windows").size(), 1u) << outside.json.dump(1);
  EXPECT_EQ(outside.of("windows")[0]["pixels"], 64 * 64);
  EXPECT_EQ(outside.code, 1);
  made.data = {-8, 0, 64, 64};
  const Doctored overscan = doctored(made);
  ASSERT_EQ(overscan.of("windows").size(), 1u);
  EXPECT_EQ(overscan.of("windows")[0]["pixels"], 8 * 64);
  EXPECT_EQ(overscan.of("windows")[0]["severity"], "hint");
}

TEST(Doctor, SubsampledChannels) {
  const TemporaryFolder folder;
  Imf::Header header(4, 4);
  header.channels().insert("N.X", Imf::Channel(Imf::FLOAT, 2, 2));
  std::vector<float> values(16);
  {
    Imf::OutputFile out((folder / "thin.exr").c_str(), header);
    Imf::FrameBuffer frame;
    frame.insert("N.X", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 8, 2, 2));
    out.setFrameBuffer(frame);
    out.writePixels(4);
  }
  const Doctored d = doctored(folder / "thin.exr");
  EXPECT_EQ(d.of("thin_channels").size(), 1u) << d.json.dump(1) << d.err;
  EXPECT_EQ(d.code, 1);
}

TEST(Doctor, MissingMaterialsAreHints) {
  const Doctored d = doctored(MadeUpGBuffer());
  EXPECT_EQ(d.of("missing_layers").size(), 2u);  // albedo, roughness
  EXPECT_EQ(d.code, 0);
}

TEST(Doctor, DuplicateLayers) {
  MadeUpGBuffer made = healthy();
  made.with({"n.x", "n.y", "n.z"});
  const Doctored d = doctored(made);
  EXPECT_EQ(d.of("duplicate_layers").size(), 1u) << d.json.dump(1);
}

TEST(Doctor, FileWithoutPositionsIsStillLookedAt) {
  const MadeUpExr file({{"", "", {"N.X", "N.Y", "N.Z", "thing"}}}, 16, 16,
                       [](const std::string& c, int x, int y) { return c == "thing" && x == 5 && y == 6 ? infinity : double(x + 1); });
  const Doctored d = doctored(file.file);
  EXPECT_EQ(d.code, 1);
  EXPECT_FALSE(d.json["understood"]);
  EXPECT_EQ(d.of("not_understood").size(), 1u) << d.json.dump(1);
  ASSERT_EQ(d.of("not_finite").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("not_finite")[0]["example"], Json({{"x", 5}, {"y", 6}}));
}

TEST(Doctor, MissingRowsAreCounted) {
  const TemporaryFolder folder;
  MadeUpGBuffer made = healthy();
  write_gbuffer(folder / "whole.exr", made);  // ZIP: blocks of 16 rows
  std::string bytes = text_of_file(folder / "whole.exr");
  std::ofstream(folder / "cut.exr", std::ios::binary) << bytes.substr(0, bytes.size() - 10);
  const Doctored d = doctored(folder / "cut.exr");
  EXPECT_EQ(d.code, 1) << d.err;
  ASSERT_EQ(d.of("incomplete").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("incomplete")[0]["pixels"], 16 * 64);
  EXPECT_EQ(d.of("incomplete")[0]["box"], Json({{"x0", 0}, {"y0", 48}, {"x1", 64}, {"y1", 64}}));
}

TEST(Doctor, BadInputIsRefused) {
  EXPECT_EQ(run_program({"doctor", "/nowhere.exr"}).code, 2);
  const TemporaryFolder folder;
  write_gbuffer(folder / "made.exr", healthy());
  EXPECT_EQ(run_program({"doctor", (folder / "made.exr").string(), "--map", "normal=nothing"}).code, 2);
}

TEST(Doctor, PicturesOfEveryLayer) {
  const TemporaryFolder folder;
  write_gbuffer(folder / "made.exr", healthy());
  const std::vector<std::string> words{"doctor", (folder / "made.exr").string(), "--png", (folder / "views").string()};
  EXPECT_EQ(run_program(words).code, 0);
  for (const char* const name : {"normal", "position", "albedo", "roughness", "metallic", "coverage", "ids", "findings", "sheet"})
    EXPECT_TRUE(std::filesystem::exists(folder / ("views/" + std::string(name) + ".png"))) << name;
  EXPECT_EQ(run_program(words).code, 5);  // what is there stays
}

/// Counts against the answer of whoever put the defects in.
TEST(Doctor, BadPixelsOfTheCorpus) {
  const std::filesystem::path folder = std::filesystem::path(RELUME_CORPUS) / "conventions";
  if (!std::filesystem::exists(folder / "bad_pixels.exr")) GTEST_SKIP() << "the corpus is not there";
  const Json answer = Json::parse(text_of_file(folder / "bad_pixels.answer.json"));
  const Doctored d = doctored(folder / "bad_pixels.exr");
  const std::map<std::string, std::string> layer_of{{"normal", "N"}, {"position", "P"}, {"albedo", "albedo"}, {"roughness", "roughness"}};
  const std::map<std::string, std::string> words_of{{"nan", "are NaN"}, {"inf", "are infinite"}, {"-inf", "are minus infinite"}, {"0.0", "is zero"}};
  std::size_t named = 0;
  for (const Json& defect : answer["defects"])
    for (const Json& f : d.json["findings"])
      if (f["layer"] == layer_of.at(defect["role"]) && f["what"].get<std::string>().find(words_of.at(defect["value"])) != std::string::npos) {
        EXPECT_EQ(f["pixels"], defect["pixels"].size()) << f.dump();
        ++named;
      }
  EXPECT_EQ(named, answer["defects"].size());
  EXPECT_EQ(d.code, 1);
}

}  // namespace
}  // namespace relume
