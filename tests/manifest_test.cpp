// Names of objects: the specification's test vectors of their hash, manifests good and hostile, names that are near.
#include "gbuffer/cryptomatte_manifest.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <random>

#include "gbuffer/cryptomatte_id.h"
#include "gbuffer/near_names.h"
#include "tests/refusal.h"
#include "tests/run_program.h"

namespace relume {
namespace {

double sample_of(std::uint32_t id) { return double(std::bit_cast<float>(id)); }

TEST(CryptomatteId, TheSpecificationsTestVectors) {
  EXPECT_EQ(cryptomatte_id("torus"), 4053562365u);
  EXPECT_NEAR(sample_of(cryptomatte_id("torus")), -1.54943624832e+30, 1e19);
  EXPECT_EQ(cryptomatte_id("равнина"), 2518896926u);
  EXPECT_NEAR(sample_of(cryptomatte_id("равнина")), -1.31926312124e-25, 1e-36);
}

/// Of Arnold's and Blender's manifests: every length modulo four, and the empty name.
TEST(CryptomatteId, RenderersManifests) {
  const std::map<std::string, std::uint32_t> known{{"bunny", 0x13851a76}, {"default", 0x42c9679f}, {"plant", 0x51bce536}, {"set", 0x5ecc6fe8},
                                                   {"Floor", 0x6a2fb16e}, {"Cube", 0xa8fce865},    {"Key", 0x91cc5916},   {"Suzanne", 0xcb432898},
                                                   {"", 0x00800000},      {"flowerA", 0xe2c8d131}, {"Torus", 0x789a1936}, {"heroflower", 0x6b2b718d}};
  for (const auto& [name, id] : known) EXPECT_EQ(cryptomatte_id(name), id) << name;
}

TEST(CryptomatteId, IsAlwaysANormalNumber) {
  int mended = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t id = cryptomatte_id("object" + std::to_string(i));
    ASSERT_TRUE(std::isnormal(std::bit_cast<float>(id))) << i;
    const std::uint32_t exponent = id >> 23 & 255;
    mended += exponent == 1 || exponent == 254;
  }
  EXPECT_GT(mended, 1000);  // 4 of 256 exponents, two of them by the exception
}

TEST(Manifest, NamesAndIds) {
  const Manifest manifest =
      parse_manifest(R"( {"bunny":"13851a76", "a \"quoted\", name":"AF8BFA09", "равнина":"9623511e", "\/obj\/box":"00c0ffee"} )", "here");
  EXPECT_TRUE(manifest.notes.empty());
  EXPECT_EQ(manifest.ids.size(), 4u);
  EXPECT_EQ(manifest.ids.at("a \"quoted\", name"), 0xaf8bfa09u);
  EXPECT_EQ(manifest.ids.at("/obj/box"), 0x00c0ffeeu);
  EXPECT_EQ(manifest.names.at(0x9623511e), "равнина");
}

TEST(Manifest, WhatIsNotSoIsLeftOutAndSaid) {
  const auto noted = [](const std::string& json, std::size_t names) {
    const Manifest manifest = parse_manifest(json, "the header");
    EXPECT_EQ(manifest.ids.size(), names) << json;
    EXPECT_EQ(manifest.notes.size(), 1u) << json;
    return manifest.notes.empty() ? "" : after("the manifest in the header ", manifest.notes.front());
  };
  EXPECT_EQ(noted("", 0), "is no JSON object: names are hashed instead");
  EXPECT_EQ(noted("[\"a\"]", 0), "is no JSON object: names are hashed instead");
  EXPECT_EQ(noted("12", 0), "is no JSON object: names are hashed instead");
  EXPECT_EQ(noted(R"({"a":"00000001","b":")", 1), "is not valid JSON after 1 names: others are hashed instead");
  EXPECT_EQ(noted("{\"a\":\"00000001\",\"\xff\xfe\":\"00000002\"}", 1), "is not valid JSON after 1 names: others are hashed instead");
  EXPECT_EQ(noted(R"({"a":"00000001"} x)", 1), "is not valid JSON after 1 names: others are hashed instead");
  EXPECT_EQ(noted(R"({"a":"000000001","b":"xyz","c":"","d":"-1","e":"0x1","f":12,"g":null,"h":["00000001"],"i":{"j":"00000001"},"k":"00000002"})", 1),
            "has 9 values that are no ids of 8 hexadecimal digits: left out");
  const Manifest deep = parse_manifest(R"({"a":)" + std::string(1 << 20, '['), "the header");
  EXPECT_TRUE(deep.empty());
  EXPECT_EQ(deep.notes.size(), 2u);  // a value that is no id, and no end
}

/// Any bytes end in names and notes: nothing is thrown, and every name has an id.
TEST(Manifest, AnyBytesAreRead) {
  const std::string good = R"({"bunny":"13851a76","a \"quoted\" \u0440":"af8bfa09","deep":[{"x":[1,2.5e3,true,null]}],"set":"5ecc6fe8"})";
  std::mt19937 random(1);
  std::size_t names = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string bytes = good.substr(0, 1 + random() % good.size());
    for (int k = int(random() % 4); k > 0; --k) bytes[random() % bytes.size()] = char(random());
    const Manifest manifest = parse_manifest(bytes, "the header");
    EXPECT_LE(manifest.names.size(), manifest.ids.size());
    EXPECT_LE(manifest.ids.size(), 4u);
    names += manifest.ids.size();
  }
  EXPECT_GT(names, 10000u);
}

TEST(Manifest, IsBounded) {
  std::string json = "{";
  for (int i = 0; i < (1 << 20) + 10; ++i) json += '"' + std::to_string(i) + "\":\"1\",";
  json.back() = '}';
  const Manifest manifest = parse_manifest(json, "the header");
  EXPECT_EQ(manifest.ids.size(), std::size_t(1) << 20);
  ASSERT_EQ(manifest.notes.size(), 1u);
  EXPECT_NE(manifest.notes.front().find("more than 1048576 names"), std::string::npos);
}

TEST(Manifest, SidecarsLieBesideTheImage) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "names");
  for (const char* name : {"objects.json", "names/objects.json", "objects.txt", "a b.json"}) std::ofstream(folder / name) << R"({"a":"00000001"})";
  const auto read = [&](const std::string& sidecar) { return read_manifest(folder / "shot.exr", R"({"header":"00000002"})", sidecar); };
  for (const char* good : {"objects.json", "names/objects.json", "a b.json"}) {
    const Manifest manifest = read(good);
    EXPECT_TRUE(manifest.ids.contains("a")) << good;
    EXPECT_EQ(manifest.source, good);
  }
  const std::string up = (folder.path().filename() / "objects.json").string();
  const std::vector<std::string> elsewhere{"../" + up,
                                           "./objects.json",
                                           "names/../objects.json",
                                           (folder / "objects.json").string(),
                                           "file:///objects.json",
                                           "C:/objects.json",
                                           "names\\objects.json",
                                           "objects.txt",
                                           "names",
                                           "",
                                           "missing.json",
                                           "a\nb.json",
                                           "/dev/zero"};
  for (const std::string& bad : elsewhere) {
    const Manifest manifest = read(bad);
    EXPECT_FALSE(manifest.ids.contains("a")) << bad;
    EXPECT_TRUE(manifest.ids.contains("header")) << bad;  // what the header itself has is taken then
    ASSERT_EQ(manifest.notes.size(), 1u) << bad;
    EXPECT_EQ(manifest.notes.front().find('\n'), std::string::npos);
  }
}

TEST(NearNames, FindsWhatWasMeant) {
  const std::vector<std::string> names{"Cube", "Sphere", "torus", "torus_hole", "/world/torus", "Floor"};
  EXPECT_EQ(near_names("torsu", names), "near: \"torus\"");
  EXPECT_EQ(near_names("CUBE", names), "near: \"Cube\"");
  EXPECT_EQ(near_names("torus", {"/world/torus", "x"}), "near: \"/world/torus\"");
  EXPECT_EQ(near_names("qqqqqqqq", names), "has: \"Cube\", \"Sphere\", \"torus\", \"torus_hole\", \"/world/torus\", and 1 more");
  EXPECT_EQ(near_names("x", {}), "");
  EXPECT_EQ(near_names("ab", {"a\nb"}), "near: \"a\\nb\"");
}

}  // namespace
}  // namespace relume
