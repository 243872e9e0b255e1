// Pixels that mix surfaces, shaded surface by surface: against supersampled images of a made-up scene, and against renderers' own anti-aliased ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using Rgb = std::array<std::vector<float>, 3>;

Rgb rgb_of(const Channels& channels, const std::string& prefix = "") {
  return {channels.at(prefix + "R"), channels.at(prefix + "G"), channels.at(prefix + "B")};
}

double rms(const Rgb& image, const Rgb& reference, const std::vector<bool>& chosen) {
  double squares = 0, count = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (chosen[i]) squares += std::pow(double(image[c][i]) - reference[c][i], 2), ++count;
  return std::sqrt(squares / std::max(count, 1.0));
}

Channels shaded(const fs::path& gbuffer, const fs::path& rig, std::vector<std::string> options) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.exr").string();
  options.insert(options.begin(), {"shade", gbuffer.string(), "--lights", rig.string(), "-o", out, "--quiet", "--device", "twin"});
  const ProgramRun run = run_program(options);
  EXPECT_EQ(run.code, 0) << gbuffer << ": " << run.err;
  return run.code == 0 ? read_channels(out) : Channels{};
}

std::vector<std::string> with(std::vector<std::string> options, std::initializer_list<std::string> more) {
  options.insert(options.end(), more);
  return options;
}

// The made-up scene: a ball over a floor that ends, so ball meets floor, both meet the background, and all three meet.

constexpr int width = 120, height = 90, finer = 8;

const char* const rig_json = R"({"relume": 1, "camera": {"world_from_camera": [1,0,0,0, 0,1,0,0, 0,0,1,5, 0,0,0,1], "vertical_fov": 30},
 "lights": [{"type": "point", "position": [3, 4, 3], "intensity": [60, 55, 50]},
            {"type": "directional", "direction": [1, -0.4, -0.6], "intensity": [0.3, 0.4, 0.8]}]})";

/// How a renderer makes one pixel of many samples.
enum class Manner {
  premultiplied,    ///< means, misses count as 0: Mitsuba, Arnold
  centre_position,  ///< the same, but the position is that of the pixel's centre: Blender
  over_hits         ///< position over hits, normals made unit again, colours over all: pbrt
};

ScenePixel filtered(const MadeUpGBuffer& made, Manner manner, int x, int y) {
  MadeUpGBuffer fine = made;
  fine.data = fine.display = {0, 0, finer * made.display.width(), finer * made.display.height()};
  ScenePixel mean;
  double hits = 0;
  for (int j = 0; j < finer; ++j)
    for (int i = 0; i < finer; ++i) {
      const ScenePixel sample = scene_at(fine, finer * x + i, finer * y + j);
      hits += sample.id != 0;
      mean.position += sample.position, mean.normal += sample.normal, mean.albedo += sample.albedo;
    }
  const double all = finer * finer;
  mean.albedo /= all;
  mean.alpha = hits / all;
  mean.normal = manner == Manner::over_hits && hits > 0 ? glm::normalize(mean.normal) : mean.normal / all;
  mean.position /= manner == Manner::over_hits ? std::max(hits, 1.0) : all;
  if (manner == Manner::centre_position) mean.position = scene_at(made, x, y).position;
  return mean;
}

struct MadeUp {
  TemporaryFolder folder;
  fs::path gbuffer = folder / "gbuffer.exr", rig = folder / "rig.json";
  std::vector<std::string> options;
  Rgb reference;
  std::vector<bool> edges;

  explicit MadeUp(Manner manner, std::initializer_list<const char*> more = {}) {
    MadeUpGBuffer made = MadeUpGBuffer::of_size(width, height);
    made.with({"albedo.R", "albedo.G", "albedo.B"});
    made.with(more);
    MadeUpGBuffer fine = made;
    fine.data = fine.display = {0, 0, finer * width, finer * height};
    made.pixel = [=](int x, int y, ScenePixel& pixel) { pixel = filtered(made, manner, x, y); };
    write_gbuffer(gbuffer, made);
    write_gbuffer(folder / "fine.exr", fine);
    std::ofstream(rig) << rig_json;
    options = {"--diffuse", "lambert",    "--specular", "ggx",      "--set", "roughness=0.5",
               "--map",     "position=P", "--map",      "normal=N", "--map", "albedo=albedo"};
    reference = averaged(rgb_of(shaded(folder / "fine.exr", rig, options)));
    const char* convention = manner == Manner::premultiplied ? "mitsuba" : manner == Manner::centre_position ? "blender" : "pbrt";
    options = with(options, {"--convention", convention, "--camera", rig.string(), "--position-space", "world", "--normal-space", "world"});
    find_edges(fine);
  }

  static Rgb averaged(const Rgb& fine) {
    Rgb mean;
    for (std::size_t c = 0; c < 3; ++c) {
      mean[c].resize(width * height);
      for (std::size_t i = 0; i < fine[c].size(); ++i) {
        const std::size_t x = i % (finer * width) / finer, y = i / (finer * width) / finer;
        mean[c][y * width + x] += fine[c][i] / float(finer * finer);
      }
    }
    return mean;
  }

  /// Pixels whose samples do not show the same object, or nothing, all of them.
  void find_edges(const MadeUpGBuffer& fine) {
    edges.resize(width * height);
    for (int y = 0; y < height * finer; ++y)
      for (int x = 0; x < width * finer; ++x)
        if (scene_at(fine, x, y).id != scene_at(fine, x / finer * finer, y / finer * finer).id)
          edges[std::size_t(y / finer) * width + std::size_t(x / finer)] = true;
  }
};

class MadeUpEdges : public ::testing::TestWithParam<Manner> {};

TEST_P(MadeUpEdges, HaveHalfTheErrorOfNaiveShading) {
  const MadeUp scene(GetParam());
  const Rgb mended = rgb_of(shaded(scene.gbuffer, scene.rig, scene.options)),
            naive = rgb_of(shaded(scene.gbuffer, scene.rig, with(scene.options, {"--edges", "as-stored"})));
  const double after = rms(mended, scene.reference, scene.edges), before = rms(naive, scene.reference, scene.edges);
  std::printf("%d pixels at edges: naive %.5f, mended %.5f, ratio %.2f\n", int(std::count(scene.edges.begin(), scene.edges.end(), true)), before,
              after, after / before);
  EXPECT_GT(std::count(scene.edges.begin(), scene.edges.end(), true), 150);
  EXPECT_LE(after, 0.5 * before);
}

TEST_P(MadeUpEdges, AreTheSameInBandsAndInACrop) {
  const MadeUp scene(GetParam());
  const Channels whole = shaded(scene.gbuffer, scene.rig, scene.options);
  const Channels bands = shaded(scene.gbuffer, scene.rig, with(scene.options, {"--memory", "200K"}));
  for (const auto& [name, values] : whole) EXPECT_EQ(values, bands.at(name)) << name;
  const Channels crop = shaded(scene.gbuffer, scene.rig, with(scene.options, {"--crop", "40,30,80,60"}));
  for (const auto& [name, values] : crop)
    for (int y = 30; y < 60; ++y)
      for (int x = 40; x < 80; ++x)
        ASSERT_EQ(values[std::size_t((y - 30) * 40 + x - 40)], whole.at(name)[std::size_t(y * width + x)]) << x << ' ' << y;
}

TEST_P(MadeUpEdges, KeepLayersThatAddUp) {
  const MadeUp scene(GetParam());
  const Channels image = shaded(scene.gbuffer, scene.rig, with(scene.options, {"--layers", "diffuse,specular"}));
  for (const char* c : {"R", "G", "B"})
    for (std::size_t i = 0; i < scene.edges.size(); ++i) {
      const float sum = image.at(std::string("diffuse.") + c)[i] + image.at(std::string("specular.") + c)[i];
      ASSERT_NEAR(image.at(c)[i], sum, 1e-5f * (1 + sum));
    }
}

TEST_P(MadeUpEdges, KeepTheirAlpha) {
  const MadeUp scene(GetParam(), {"R", "G", "B", "A"});
  for (const char* edges : {"mend", "as-stored"}) {
    const Channels image = shaded(scene.gbuffer, scene.rig, with(scene.options, {"--map", "coverage=RGBA", "--edges", edges}));
    const std::vector<float> stored = read_channels(scene.gbuffer).at("A");
    for (std::size_t i = 0; i < scene.edges.size(); ++i) ASSERT_NEAR(image.at("A")[i], stored[i], 2e-3) << edges << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Manners, MadeUpEdges, ::testing::Values(Manner::premultiplied, Manner::centre_position, Manner::over_hits));

TEST(Edges, OfUnfilteredFilesAreShadedAsTheyAre) {
  const TemporaryFolder folder;
  MadeUpGBuffer made = MadeUpGBuffer::of_size(width, height);
  made.with({"albedo.R", "albedo.G", "albedo.B"});
  write_gbuffer(folder / "gbuffer.exr", made);
  std::ofstream(folder / "rig.json") << rig_json;
  for (const char* convention : {"generic", "blender", "pbrt", "mitsuba"}) {
    const std::vector<std::string> options{"--convention", convention, "--map",         "position=P", "--map",
                                           "normal=N",     "--map",    "albedo=albedo", "--camera",   (folder / "rig.json").string()};
    const Channels mended = shaded(folder / "gbuffer.exr", folder / "rig.json", options),
                   naive = shaded(folder / "gbuffer.exr", folder / "rig.json", with(options, {"--edges", "as-stored"}));
    for (const auto& [name, values] : mended) EXPECT_EQ(values, naive.at(name)) << convention << ' ' << name;
  }
}

// Renderers' own files.

struct Case {
  std::string name;
  fs::path gbuffer, rig, reference;
  std::vector<std::string> options;
  bool out_of_reach = false;  ///< half the error, whatever is done: docs/truth.md says why
};

nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(std::ifstream(file)); }

std::vector<Case> cases() {
  const fs::path corpus = RELUME_CORPUS;
  std::vector<Case> all;
  for (const char* name : {"mitsuba/aa64_gaussian", "mitsuba/aa64_box_glossy", "blender/filtered", "blender/dwaa", "pbrt/antialiased-f32"}) {
    const fs::path folder = corpus / name;
    const nlohmann::json facts = json_of(folder / "case.json");
    Case c{name, folder / "gbuffer.exr", folder / "rig.json", folder / "reference.exr", {}};
    if (facts.contains("relume_shade")) c.options = facts["relume_shade"].get<std::vector<std::string>>();
    if (fs::exists(folder / "materials.json")) c.options = {"--materials", (folder / "materials.json").string()};
    if (fs::exists(folder / "rig.gltf")) c.rig = folder / "rig.gltf";
    c.out_of_reach = std::string(name).starts_with("pbrt");
    all.push_back(c);
  }
  const fs::path conventions = corpus / "conventions";
  const std::vector<std::string> lambert{"--diffuse", "lambert", "--specular", "none"};
  all.push_back(
      {"conventions/mitsuba3", conventions / "mitsuba3.exr", conventions / "rig_yup.json", conventions / "reference_lambert_filtered.exr", lambert});
  all.push_back({"conventions/arnold_box_half", conventions / "arnold_box_half.exr", conventions / "rig_yup.json",
                 conventions / "reference_lambert_filtered.exr",
                 with(lambert, {"--convention", "mitsuba", "--map", "position=P", "--map", "normal=N", "--map", "albedo=diffuse_albedo"})});
  return all;
}

Rgb reference_of(const Case& c) {
  const Channels image = read_channels(c.reference);
  if (!image.contains("ViewLayer.DiffDir.R")) return rgb_of(image);
  Rgb sum = rgb_of(image, "ViewLayer.DiffDir.");
  const Rgb diffuse = rgb_of(image, "ViewLayer.DiffCol."), light = rgb_of(image, "ViewLayer.GlossDir."), gloss = rgb_of(image, "ViewLayer.GlossCol.");
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < sum[k].size(); ++i) sum[k][i] = sum[k][i] * diffuse[k][i] + light[k][i] * gloss[k][i];
  return sum;
}

/// Short normals, broken ids; where normals were made unit again, pixels beside the background.
std::vector<bool> edges_of(const Channels& gbuffer) {
  std::string normal;
  for (const char* name : {"sh_normal.", "ViewLayer.Normal.", "Ns.", "nn.", "N."})
    if (normal.empty() && gbuffer.contains(std::string(name) + "X")) normal = name;
  const std::vector<float>&x = gbuffer.at(normal + "X"), &y = gbuffer.at(normal + "Y"), &z = gbuffer.at(normal + "Z");
  std::vector<bool> edges(x.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double length = std::sqrt(double(x[i]) * x[i] + double(y[i]) * y[i] + double(z[i]) * z[i]);
    const float id = gbuffer.contains("shape_index.I") ? gbuffer.at("shape_index.I")[i] : 0;
    edges[i] = (length > 1e-4 && length < 0.985) || std::abs(id - std::round(id)) > 0.01f;
    if (normal == "Ns." && i > 0 && i + 1 < edges.size()) edges[i] = length > 0 && (x[i - 1] == 0 || x[i + 1] == 0);
  }
  return edges;
}

/// The stored albedo times whatever irradiance suits the reference best, pixel by pixel: under white lights no Lambertian relighter comes closer.
Rgb in_hindsight(const Channels& gbuffer, const Rgb& reference) {
  Rgb image = rgb_of(gbuffer, "Albedo.");
  for (std::size_t i = 0; i < image[0].size(); ++i) {
    double along = 0, squared = 0;
    for (std::size_t c = 0; c < 3; ++c) along += double(image[c][i]) * reference[c][i], squared += double(image[c][i]) * image[c][i];
    for (std::size_t c = 0; c < 3; ++c) image[c][i] *= squared > 0 ? float(along / squared) : 0;
  }
  return image;
}

TEST(Edges, OfRenderersFilesHaveHalfTheErrorOfNaiveShading) {
  if (!fs::exists(RELUME_CORPUS)) GTEST_SKIP() << "the corpus is not beside the project";
  std::printf("| anti-aliased file            | edge pixels | naive rms | mended rms | ratio | all, naive dB | mended dB |\n");
  for (const Case& c : cases()) {
    const Rgb reference = reference_of(c);
    const Rgb mended = rgb_of(shaded(c.gbuffer, c.rig, c.options)),
              naive = rgb_of(shaded(c.gbuffer, c.rig, with(c.options, {"--edges", "as-stored"})));
    const Channels gbuffer = read_channels(c.gbuffer);
    const std::vector<bool> edges = edges_of(gbuffer), all(edges.size(), true);
    const double before = rms(naive, reference, edges), after = rms(mended, reference, edges);
    std::vector<float> values = reference[1];
    const auto peak = values.begin() + std::ptrdiff_t(double(values.size()) * 0.999);
    std::nth_element(values.begin(), peak, values.end());
    const auto decibel = [&](const Rgb& image) { return -20 * std::log10(rms(image, reference, all) / *peak); };
    std::printf("| %-28s | %11d | %9.5f | %10.5f | %5.2f | %13.1f | %9.1f |\n", c.name.c_str(), int(std::count(edges.begin(), edges.end(), true)),
                before, after, after / before, decibel(naive), decibel(mended));
    EXPECT_LE(after, (c.out_of_reach ? 1.001 : 0.5) * before) << c.name;
    EXPECT_GE(decibel(mended), decibel(naive) - 0.01) << c.name;
    if (!c.out_of_reach) continue;
    const double least = rms(in_hindsight(gbuffer, reference), reference, edges);
    std::printf("  its albedo leaves at least a ratio of %.2f\n", least / before);
    EXPECT_GT(least, 0.5 * before) << c.name;
  }
}

}  // namespace
}  // namespace relume
