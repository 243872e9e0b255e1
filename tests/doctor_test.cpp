// relume doctor: ailments of whole files and headers, files that cannot be relit, and its pictures.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "tests/doctored.h"
#include "tests/made_up_exr.h"

namespace relume {
namespace {

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
  made.header = [](Imf::Header& header) {  // the same, as V-Ray states it
    header.insert("cameraTransform", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, float(scene_eye_z), 1}));
  };
  EXPECT_EQ(doctored(made).of("camera"), contradicted.of("camera"));
}

TEST(Doctor, RoundedPositionsDoNotContradictACamera) {
  constexpr float far = 900;  // half precision steps by 0.5 there: several pixels
  MadeUpGBuffer made;
  made.half = true;
  made.floor = false;
  made.camera_in_header = false;
  made.pixel = [](int, int, ScenePixel& p) {
    if (p.id) p.position.x += far;
  };
  made.header = [](Imf::Header& header) {
    header.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, -far, 0, float(scene_eye_z), 1}));
  };
  EXPECT_EQ(doctored(made).of("camera"), std::vector<Json>{});
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
  const MadeUpExr file({{"", "", {"N.X", "N.Y", "N.Z", "thing"}}}, 16, 16, [](const std::string& c, int x, int y) {
    return c == "thing" && x == 5 && y == 6 ? std::numeric_limits<double>::infinity() : double(x + 1);
  });
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
