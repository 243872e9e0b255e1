// Objects of pixels: shares and names from Cryptomattes, ids that floats cannot hold, layers of means, and files that Blender wrote.
#include "gbuffer/object_ids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gbuffer/cryptomatte_id.h"
#include "tests/made_cryptomatte.h"
#include "tests/make_gbuffer.h"
#include "tests/refusal.h"
#include "tests/run_program.h"

namespace relume {
namespace {

/// Ids of a made-up or stored file, over its whole frame.
struct Objects {
  explicit Objects(const std::filesystem::path& path, const std::string& name = "", bool by_names = true)
      : file(path),
        reading(understand(file, {})),
        ids(file, reading, name, by_names),
        gbuffer(read_gbuffer(file, reading, reading.data_window, ids.roles(), 0)) {}

  std::vector<float> share(const std::vector<std::string>& called) {
    const auto all = ids.ids_of(called, "test");
    return ids.shares(gbuffer, {all.begin(), all.end()});
  }

  ExrFile file;
  Reading reading;
  ObjectIds ids;
  GBuffer gbuffer;
};

const std::vector<std::string> ranks{"Crypto00.R", "Crypto00.G", "Crypto00.B", "Crypto00.A"};

TEST(ObjectIds, SharesAndTheMostCovering) {
  const MadeUpExr made({{"", "", with_geometry(ranks)}}, 8, 2, Frame8::value);
  Objects objects(made.file);
  const auto left = objects.share({"left"}), floor = objects.share({"floor"}), all = objects.share({"left", "right", "floor"});
  const auto most = objects.ids.most_covering(objects.gbuffer);
  for (std::size_t i = 0; i < 16; ++i) {
    const std::size_t x = i % 8;
    EXPECT_EQ(left[i], x < 4 ? 0.75f : 0.0f);
    EXPECT_EQ(floor[i], x < 7 ? 0.25f : 0.0f);
    EXPECT_EQ(all[i], x < 7 ? 1.0f : 0.0f);
    EXPECT_EQ(most[i], x == 7 ? 0 : cryptomatte_id(x < 4 ? "left" : "right"));
  }
}

TEST(ObjectIds, HostileCoverage) {
  const auto value = [](const std::string& channel, int x, int y) -> double {
    if (channel == "Crypto00.G") return x == 0 ? NAN : x == 1 ? -1 : x == 2 ? INFINITY : x == 3 ? 0.1 : 0.5;
    if (channel == "Crypto00.A") return x == 4 ? NAN : 0.5;  // ranks out of order at x = 3
    return Frame8::value(channel, x, y);
  };
  const MadeUpExr made({{"", "", with_geometry(ranks)}}, 8, 2, value);
  Objects objects(made.file);
  const auto floor = objects.share({"floor"});
  const auto most = objects.ids.most_covering(objects.gbuffer);
  const float expected[] = {1, 1, 1 / 3.0f, 5 / 6.0f, 0, 0.5f, 0.5f, 0};
  for (std::size_t x = 0; x < 8; ++x) EXPECT_FLOAT_EQ(floor[x], expected[x]) << x;
  EXPECT_EQ(most[0], cryptomatte_id("floor"));
  EXPECT_EQ(most[2], cryptomatte_id("left"));
  EXPECT_EQ(most[3], cryptomatte_id("floor"));
  EXPECT_EQ(most[4], cryptomatte_id("right"));
}

TEST(ObjectIds, NamesWithAndWithoutAManifest) {
  const MadeUpExr without({{"", "", with_geometry(ranks)}}, 8, 2, Frame8::value, metadata("Crypto", ""));
  Objects hashed(without.file);
  EXPECT_EQ(hashed.ids.ids_of({"left", "0x00000007"}, "test"), (std::vector<std::uint32_t>{cryptomatte_id("left"), 7}));
  EXPECT_TRUE(hashed.ids.notes().empty());
  hashed.ids.ids_of({"lfet"}, "test");
  ASSERT_EQ(hashed.ids.notes().size(), 1u);
  EXPECT_EQ(hashed.ids.notes()[0], "no pixel shows object \"lfet\", and Cryptomatte \"Crypto\" has no manifest to check the name by");

  const MadeUpExr with({{"", "", with_geometry(ranks)}}, 8, 2, Frame8::value, metadata("Crypto", R"({"left":"00000009","gone":"00000008"})"));
  Objects named(with.file);
  EXPECT_EQ(named.ids.ids_of({"left", "gone", "right"}, "test"), (std::vector<std::uint32_t>{9, 8, cryptomatte_id("right")}));  // the manifest wins
  EXPECT_EQ(named.ids.called(9), "\"left\"");
  EXPECT_EQ(named.ids.called(7), "0x00000007");
  EXPECT_EQ(error_of([&] { named.ids.ids_of({"lfet"}, "m.json"); }),
            "m.json: Cryptomatte \"Crypto\" has no object \"lfet\" (near: \"left\"; relume inspect lists them)");
}

TEST(ObjectIds, ChoosesTheLayer) {
  std::vector<std::string> channels = with_geometry({"id:uint", "CryptoMaterial00.R", "CryptoMaterial00.G", "CryptoObject00.R", "CryptoObject00.G"});
  const MadeUpExr made({{"", "", channels}}, 8, 2, Frame8::value);
  EXPECT_EQ(Objects(made.file).ids.name(), "CryptoObject");
  EXPECT_EQ(Objects(made.file, "", false).ids.name(), "id");
  EXPECT_EQ(Objects(made.file, "crypto_material").ids.name(), "CryptoMaterial");
  EXPECT_EQ(Objects(made.file, "ID").ids.name(), "id");
  EXPECT_TRUE(error_of([&] { Objects(made.file, "CryptoAsset"); }).find("no layer \"CryptoAsset\" (there are: ") != std::string::npos);
  ReadingOptions mapped;
  mapped.map["ids"] = "cryptomaterial";
  const ExrFile file(made.file);
  Reading reading = understand(file, mapped);
  EXPECT_EQ(ObjectIds(file, reading, "", false).name(), "CryptoMaterial");
  const MadeUpExr none({{"", "", geometry}}, 8, 2, Frame8::value);
  const std::string where = none.file.string(), end = " (\"ids\" in a material file or rig names one; --map ids=LAYER too)";
  EXPECT_EQ(error_of([&] { Objects(none.file, "", true); }), where + ": no Cryptomatte to find objects in by name" + end);
  EXPECT_EQ(error_of([&] { Objects(none.file, "", false); }), where + ": no layer of object ids" + end);
}

/// A float layer of ids under `number(x)`, over the geometry of Frame8.
struct FloatIds {
  explicit FloatIds(const std::function<double(int)>& number)
      : made({{"", "", with_geometry({"id"})}}, 8, 2,
             [=](const std::string& channel, int x, int y) { return channel == "id" ? number(x) : Frame8::value(channel, x, y); }),
        objects(made.file, "", false) {}
  MadeUpExr made;
  Objects objects;
};

TEST(ObjectIds, FloatsBeyondTheirWholeNumbers) {
  FloatIds small([](int x) { return 16777208 + x; });
  EXPECT_TRUE(small.objects.ids.notes().empty());
  EXPECT_EQ(small.objects.ids.most_covering(small.objects.gbuffer)[7], 16777215u);
  FloatIds large([](int x) { return 16777212.0 + x; });
  ASSERT_EQ(large.objects.ids.notes().size(), 1u);
  EXPECT_EQ(
      large.objects.ids.notes()[0],
      "warning: id layer \"id\": 8 of 16 pixels looked at hold ids from 16777216 up, where float samples do not tell every id from the next: objects "
      "may have merged");
  EXPECT_EQ(large.objects.ids.ids_of({"16777216", "16777218"}, "test"), (std::vector<std::uint32_t>{16777216, 16777218}));
  EXPECT_EQ(
      error_of([&] { large.objects.ids.ids_of({"16777217"}, "m.json"); }),
      "m.json: layer \"id\" cannot hold id 16777217: its samples are float, which near it are 2 apart (whole numbers are exact below 16777216)");
  EXPECT_EQ(error_of([&] { large.objects.ids.ids_of({"torus"}, "m.json"); }),
            "m.json: \"torus\" is a name, but layer \"id\" holds numbers (0..4294967295; a Cryptomatte in \"ids\" holds names)");
  // Every id that is let through is one that a float can be.
  for (std::uint64_t id = 1; id < 4294967296u; id += 1 + id / 7) {
    const bool fits = std::uint64_t(float(id)) == id;
    EXPECT_EQ(error_of([&] { large.objects.ids.ids_of({std::to_string(id)}, "m"); }) == "no error", fits) << id;
  }
}

TEST(ObjectIds, WholeNumberLayersAreExact) {
  const MadeUpExr made({{"", "", with_geometry({"id:uint"})}}, 8, 2,
                       [](const std::string& channel, int x, int y) { return channel == "id" ? 4294967288.0 + x : Frame8::value(channel, x, y); });
  Objects objects(made.file, "", false);
  EXPECT_TRUE(objects.ids.notes().empty());
  const auto share = objects.share({"4294967295"});
  for (std::size_t x = 0; x < 8; ++x) EXPECT_EQ(share[x], x == 7 ? 1.0f : 0.0f);
}

TEST(ObjectIds, MeansAndWhatIsNoId) {
  FloatIds mixed([](int x) { return x == 3 ? 1.5 : x < 3 ? 1.0 : 2.0; });
  ASSERT_EQ(mixed.objects.ids.notes().size(), 1u);
  EXPECT_EQ(mixed.objects.ids.notes()[0],
            "id layer \"id\": 2 of 16 pixels looked at hold a mean of several ids: each takes the id of an unmixed pixel near it");
  const auto ids = mixed.objects.ids.most_covering(mixed.objects.gbuffer);
  EXPECT_TRUE(ids[3] == 1 || ids[3] == 2) << ids[3];
  FloatIds odd([](int x) { return x == 0 ? NAN : x == 1 ? -1 : x == 2 ? 1e20 : 5; });
  ASSERT_EQ(odd.objects.ids.notes().size(), 1u);
  EXPECT_EQ(odd.objects.ids.notes()[0], "id layer \"id\": 6 of 16 pixels looked at hold no id (negative, NaN or beyond 32 bits) and count as 0");
  EXPECT_NE(error_of([] { FloatIds([](int) { return -1.5e30; }); }).find("holds no ids: all are negative, NaN or beyond 32 bits"), std::string::npos);
}

/// Blender wrote both. Two ranks are enough for their pixels, so that what all objects cover is what is covered.
TEST(ObjectIds, BlendersFiles) {
  for (const char* name : {"principled-ggx", "b5-interleaved"}) {
    Objects objects(std::filesystem::path(RELUME_SOURCE) / "tests/data/corpus/blender" / name / "gbuffer.exr", "CryptoObject");
    EXPECT_EQ(objects.ids.name(), "ViewLayer.CryptoObject");
    ObjectCounts counts;
    objects.ids.count(objects.gbuffer, counts);
    for (const char* shown : {"Floor", "Suzanne", "Sphere", "Torus", "Cube", "Capsule"})
      EXPECT_GT(counts[cryptomatte_id(shown)].pixels, 100) << shown;
    std::vector<float> sum(std::size_t(objects.gbuffer.window.pixels()));
    double coverage = 0, seen = 0;
    for (const auto& [object, id] : objects.ids.manifest().ids) {
      EXPECT_EQ(id, cryptomatte_id(object));
      const auto share = objects.share({object});
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share[i];
      coverage += counts[id].coverage;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      EXPECT_TRUE(sum[i] == 0 || std::fabs(sum[i] - 1) < 1e-6) << name << ' ' << i;
      seen += sum[i] > 0;
    }
    EXPECT_LE(coverage, seen + 1e-3);
    EXPECT_GT(coverage, 0.97 * seen);  // edges against the sky are covered in part
  }
}

TEST(Inspect, ListsObjects) {
  const std::string file = (std::filesystem::path(RELUME_SOURCE) / "tests/data/corpus/blender/principled-ggx/gbuffer.exr").string();
  const ProgramRun text = run_program({"inspect", file});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("objects       ViewLayer.CryptoObject (Cryptomatte of 2 ranks, names from the header), pixels: Floor "), std::string::npos)
      << text.out;
  const ProgramRun json = run_program({"inspect", "--json", file});
  EXPECT_NE(json.out.find("\"id\": \"0x6a2fb16e\""), std::string::npos);
  const MadeUpExr hostile({{"", "", with_geometry(ranks)}}, 8, 2, Frame8::value,
                          metadata(
                              "Crypto", "{\"\\u001b[31mred\\u202e\":\"" + [] {
                                char id[16];
                                std::snprintf(id, sizeof id, "%08x", cryptomatte_id("left"));
                                return std::string(id);
                              }() + "\"}"));
  const ProgramRun shown = run_program({"inspect", hostile.file.string(), "--convention", "generic"});
  EXPECT_EQ(shown.out.find('\x1b'), std::string::npos);
  EXPECT_NE(shown.out.find("\\x1b[31mred\\u202e 8"), std::string::npos) << shown.out << shown.err;
}

}  // namespace
}  // namespace relume
