// Measured tables looked up: on devices, its laws and its error, and frames shaded with a table beside the lobe that it was made of.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "host/merl.h"
#include "lab/tabulate.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/psnr.h"
#include "tests/random_table.h"
#include "tests/run_program.h"

namespace relume {
namespace {

Brdf brdf_of(const std::filesystem::path& file, const std::string& device = "twin") { return {file.string(), {}, open_device(device)}; }
Brdf twin_brdf(const std::string& name, const std::vector<std::string>& set) { return {name, set, open_device("twin")}; }

/// Directions above the surface, evenly in cosine, none lower than `least`.
std::vector<DirectionPair> random_pairs(int count, double least) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto direction = [&] {
    const double z = least + (1 - least) * unit(random), phi = 2 * std::numbers::pi * unit(random), r = std::sqrt(1 - z * z);
    return glm::dvec3(r * std::cos(phi), r * std::sin(phi), z);
  };
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 v = direction();
    pairs.push_back({direction(), v});
    pairs.push_back({{-v.x, -v.y, v.z}, v});
  }
  return pairs;
}

// What the kernel finds from three cosines is the bin that the directions were made for, the mean of it and of its mirror image.
TEST(MerlLookup, FindsEveryBinFromTheCosines) {
  const TemporaryFolder folder;
  const MerlTable table = random_table(24, 12, 20);
  write_merl(table, folder / "t.binary", false);
  const Brdf brdf = brdf_of(folder / "t.binary");
  std::vector<DirectionPair> pairs;
  std::vector<std::array<int, 3>> bins;
  for (int h = 0; h < table.theta_h; ++h)
    for (int d = 0; d < table.theta_d; ++d)
      for (int phi = 0; phi < table.phi_d; ++phi) {
        const DirectionPair pair = directions_of(angles_of(table, h, d, phi));
        if (pair.l.z < 1e-3 || pair.v.z < 1e-3) continue;
        pairs.push_back(pair);
        bins.push_back({h, d, phi});
      }
  const std::vector<Reflectance> found = brdf.reflectance(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const auto [h, d, phi] = bins[i];
      const auto& plane = table.f[std::size_t(c)];
      const double wanted = 0.5 * (plane[table.at(h, d, phi)] + plane[table.at(h, d, table.phi_d - 1 - phi)]);
      // Entries differ by up to 0.9; single precision's n.v - n.l tells phi_d to a share of a bin, the larger the nearer h is to n.
      EXPECT_NEAR(found[i].total()[c] / pairs[i].l.z, wanted, h < 2 ? 5e-3 : 5e-4) << h << " " << d << " " << phi;
    }
  EXPECT_GT(bins.size(), 2000u);
}

TEST(MerlLookup, IsReciprocal) {
  const TemporaryFolder folder;
  write_merl(random_table(24, 12, 20), folder / "t.binary", false);
  const Brdf brdf = brdf_of(folder / "t.binary");
  std::vector<DirectionPair> pairs = random_pairs(2000, 0.01), swapped;
  for (const DirectionPair& pair : pairs) swapped.push_back({pair.v, pair.l});
  const std::vector<Reflectance> there = brdf.reflectance(pairs), back = brdf.reflectance(swapped);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_NEAR(there[i].total().y / pairs[i].l.z, back[i].total().y / pairs[i].v.z, 1e-6) << i;
}

TEST(MerlLookup, GapsAndTheHorizonDoNotDarken) {
  const TemporaryFolder folder;
  MerlTable table = random_table(20, 15, 20, 0.6);
  for (auto& plane : table.f)
    for (float& value : plane)
      if (value >= 0) value = 0.25f;
  // Nothing is measured where light or view is below the horizon; every theta_h and phi_d has its theta_d = 0.
  for (int h = 0; h < 20; ++h)
    for (int phi = 0; phi < 20; ++phi)
      for (int d = 0; d < 15; ++d) {
        const DirectionPair pair = directions_of(angles_of(table, h, d, phi));
        for (auto& plane : table.f) plane[table.at(h, d, phi)] = d == 0 ? 0.25f : std::min(pair.l.z, pair.v.z) < 0 ? -1 : plane[table.at(h, d, phi)];
      }
  write_merl(table, folder / "t.binary", false);
  const Brdf brdf = brdf_of(folder / "t.binary");
  const std::vector<DirectionPair> pairs = random_pairs(500, 1e-3);
  const std::vector<Reflectance> found = brdf.reflectance(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_NEAR(found[i].total().x / pairs[i].l.z, 0.25, 1e-6) << i;
}

/// The root mean square of f_r between a lobe and its table of so many bins.
double interpolation_error(const Brdf& lobe, int theta_h, int theta_d, int phi_d) {
  const TemporaryFolder folder;
  write_merl(tabulate(lobe, theta_h, theta_d, phi_d), folder / "t.binary", false);
  const std::vector<DirectionPair> pairs = random_pairs(5000, 0.2);
  const std::vector<Reflectance> exact = lobe.reflectance(pairs), found = brdf_of(folder / "t.binary").reflectance(pairs);
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) sum += std::pow((exact[i].total().y - found[i].total().y) / pairs[i].l.z, 2);
  return std::sqrt(sum / double(pairs.size()));
}

// Linear interpolation: a quarter of the error with twice the bins.
TEST(MerlLookup, ErrorFallsWithTheSquareOfTheBins) {
  for (const char* name : {"lambert+ggx", "lambert+phong", "oren_nayar"}) {
    std::vector<std::string> set{"albedo=0.5,0.3,0.1"};
    if (std::string(name) == "lambert+ggx") set.push_back("alpha=0.4");
    const Brdf lobe = twin_brdf(name, set);
    const double coarse = interpolation_error(lobe, 12, 12, 16), middle = interpolation_error(lobe, 24, 24, 32),
                 fine = interpolation_error(lobe, 48, 48, 64);
    std::printf("%-14s rms of f_r: %.2e with 12 x 12 x 16 bins, %.2e, %.2e with 48 x 48 x 64\n", name, coarse, middle, fine);
    EXPECT_LT(middle, 0.5 * coarse) << name;
    EXPECT_LT(fine, 0.5 * middle) << name;
  }
  EXPECT_LT(interpolation_error(twin_brdf("lambert", {"albedo=0.5,0.3,0.1"}), 4, 4, 4), 1e-7);  // a constant is exact
}

TEST(MerlLookup, DevicesAgreeWithTheTwin) {
  const TemporaryFolder folder;
  write_merl(random_table(24, 12, 20, 0.9), folder / "t.binary", false);
  const std::vector<DirectionPair> pairs = random_pairs(3000, 1e-6);
  const std::vector<Reflectance> expected = brdf_of(folder / "t.binary").reflectance(pairs);
  int compared = 0;
  for (const DeviceInfo& info : list_devices()) {
    if (!info.correctly_rounded) continue;
    const std::vector<Reflectance> found = brdf_of(folder / "t.binary", std::to_string(info.index)).reflectance(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(found[i].specular, expected[i].specular) << info.name << " " << i;
    ++compared;
  }
  if (compared == 0) GTEST_SKIP() << "no OpenCL device that rounds divide and square root correctly";
}

/// A small frame under one light, in a folder of its own.
struct Scene {
  Scene() {
    MadeUpGBuffer made = MadeUpGBuffer::of_size(48, 48);
    made.with({"id"});
    write_gbuffer(folder / "g.exr", made);
    std::ofstream(folder / "rig.json") << R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 30, 20]}]})";
  }
  std::string in(const std::string& name) const { return (folder / name).string(); }
  ProgramRun shade(const std::string& output, std::vector<std::string> options) const {
    options.insert(options.begin(), {"shade", in("g.exr"), "-l", in("rig.json"), "-o", in(output), "--float", "--quiet", "--device", "twin"});
    return run_program(options);
  }
  Rgb picture(const std::string& name) const { return rgb_of(read_channels(folder / name)); }
  TemporaryFolder folder;
};

TEST(Merl, AFrameShadedWithATableIsTheLobesOwn) {
  const Scene scene;
  const std::vector<std::string> set{"albedo=0.4,0.2,0.1", "alpha=0.3", "f0=0.5"};
  const ProgramRun tabulated =
      run_program({"tabulate", "lambert+ggx", "--set", set[0], "--set", set[1], "--set", set[2], "-o", scene.in("ggx.binary"), "--device", "twin"});
  ASSERT_EQ(tabulated.code, 0) << tabulated.err;
  EXPECT_EQ(run_program({"tabulate", "ggx", "-o", scene.in("ggx.binary")}).code, 5);  // exists
  const ProgramRun lobe = scene.shade("lobe.exr", {"--diffuse", "lambert", "--specular", "ggx", "--set", set[0], "--set", set[1], "--set", set[2]});
  ASSERT_EQ(lobe.code, 0) << lobe.err;
  const ProgramRun table = scene.shade("table.exr", {"--diffuse", "none", "--specular", "merl", "--set", "table=" + scene.in("ggx.binary")});
  ASSERT_EQ(table.code, 0) << table.err;
  // Whoever names a table wants it shown, and nothing beside it.
  ASSERT_EQ(scene.shade("short.exr", {"--set", "table=" + scene.in("ggx.binary")}).code, 0);
  EXPECT_EQ(scene.picture("short.exr"), scene.picture("table.exr"));
  const Rgb expected = scene.picture("lobe.exr");
  const double db = psnr(scene.picture("table.exr"), expected, std::vector<bool>(expected[0].size(), true));
  std::printf("a frame with a table of 90 x 90 x 180: %.1f dB from its lobe\n", db);
  EXPECT_GT(db, 60);
  // The material file finds it beside itself, not in the working directory.
  std::ofstream(scene.folder / "m.json")
      << R"({"relume": 1, "ids": "id", "materials": {"default": {"diffuse": "none", "specular": "merl", "table": "ggx.binary"}}})";
  const ProgramRun file = scene.shade("file.exr", {"--materials", scene.in("m.json")});
  ASSERT_EQ(file.code, 0) << file.err;
  EXPECT_EQ(scene.picture("file.exr"), scene.picture("table.exr"));
  const ProgramRun row = run_program({"evaluate", scene.in("ggx.binary"), "--device", "twin"}, "n_l,n_v,l_v\n0.9,0.9,0.7\n");
  ASSERT_EQ(row.code, 0) << row.err;
  EXPECT_EQ(row.out.find("n_l,n_v,l_v,f_r.r,f_r.g,f_r.b,reflectance.r"), 0u) << row.out;
}

// Two materials with one table share it in the buffer; a third has its own.
TEST(Merl, ATableIsInTheBufferOnce) {
  const TemporaryFolder folder;
  write_merl(random_table(8, 8, 8), folder / "a.binary", false);
  write_merl(random_table(8, 8, 16), folder / "b.binary", false);
  std::ofstream(folder / "m.json")
      << R"({"relume": 1, "materials": {"1": {"table": "a.binary"}, "2": {"table": "a.binary"}, "3": {"table": "b.binary"}}})";
  const MaterialFile file = read_materials(folder / "m.json");
  const LayerFinder no_layers = [](const std::string&) -> RoleLayer { return {}; };
  Reading reading;
  reading.default_diffuse = "lambert";
  reading.default_specular = "none";
  const auto bytes_of = [&](std::initializer_list<std::uint32_t> ids) {
    MaterialFile some;
    for (const std::uint32_t id : ids) some.by_id[id] = file.by_id.at(id);
    const Binding binding({}, some, "test", no_layers, reading);
    EXPECT_EQ(binding.descriptions(), std::vector<std::string>{"none + merl"});
    return binding.tables().size();
  };
  EXPECT_EQ(bytes_of({1, 2}), bytes_of({1}));
  EXPECT_GE(bytes_of({1, 2, 3}), bytes_of({1}) + 3 * 8 * 8 * 8);
}

TEST(Merl, WhatIsWrongWithATableIsSaidInOneLine) {
  const Scene scene;
  const auto error = [&](std::vector<std::string> options) {
    const ProgramRun run = scene.shade("x.exr", std::move(options));
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(scene.folder / "x.exr"));
    return run.err;
  };
  EXPECT_NE(error({"--specular", "merl", "--set", "table=" + scene.in("none.binary")}).find("none.binary: no such file"), std::string::npos);
  EXPECT_NE(error({"--specular", "merl", "--set", "table="}).find("must name a file"), std::string::npos);
  EXPECT_NE(error({"--specular", "merl", "--set", "table=" + scene.in("rig.json")}).find("is no MERL table"), std::string::npos);
  EXPECT_NE(error({"--map", "table=N.X"}).find("table"), std::string::npos);
  for (const char* value : {"3", "\"\"", "[1, 2, 3]", R"({"texture": "t.exr"})"}) {
    std::ofstream(scene.folder / "m.json") << R"({"relume": 1, "materials": {"default": {"specular": "merl", "table": )" << value << "}}}";
    EXPECT_NE(error({"--materials", scene.in("m.json")}).find("table"), std::string::npos) << value;
  }
  // Nothing is named: a made-up one stands in, and that is said.
  ProgramRun run = scene.shade("stand-in.exr", {"--specular", "merl"});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Merl, TheListSaysThatATableIsAFile) {
  const ProgramRun list = run_program({"list", "brdfs", "--json"});
  const auto lists = nlohmann::json::parse(list.out);
  const auto& brdfs = lists["brdfs"];
  const auto merl = std::find_if(brdfs.begin(), brdfs.end(), [](const auto& lobe) { return lobe["name"] == "merl"; });
  ASSERT_NE(merl, brdfs.end());
  EXPECT_EQ((*merl)["parameters"][0]["name"], "table");
  EXPECT_EQ((*merl)["parameters"][0]["file"], true);
}

}  // namespace
}  // namespace relume
