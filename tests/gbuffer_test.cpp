// Bands made plain: unit world-space normals, coverage, whole ids, whatever the file's filtering, space or defects.
#include "gbuffer/gbuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "tests/made_up_exr.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
const fs::path corpus = RELUME_CORPUS;

#define NEEDS_CORPUS(renderer) \
  if (!fs::exists(corpus / renderer)) GTEST_SKIP() << "the corpus is not beside the project: " << (corpus / renderer)

struct Loaded {
  ExrFile file;
  Reading reading;
  GBuffer g;

  Loaded(const fs::path& path, const std::vector<std::string>& roles, const ReadingOptions& options = {})
      : file(path), reading(understand(file, options)), g(read_gbuffer(file, reading, reading.data_window, roles, 0)) {}

  glm::dvec3 vector(const PlaneRange& range, std::size_t i) const {
    return {g.planes.plane(range.first)[i], g.planes.plane(range.first + 1)[i], g.planes.plane(range.first + 2)[i]};
  }
  float coverage(std::size_t i) const { return g.planes.plane(g.coverage.first)[i]; }
  std::size_t pixels() const { return std::size_t(g.window.pixels()); }
};

std::vector<float> channel(const fs::path& path, const std::string& name) {
  const ExrFile file(path);
  const Window window = file.parts()[0].data_window;
  std::vector<float> values(std::size_t(window.pixels()));
  const std::vector<Destination> to{{name, SampleType::float32, values.data(), 4, 4 * std::size_t(window.width())}};
  file.read(0, window, to);
  return values;
}

/// What holds of every band, whoever wrote the file.
void check_plain(const Loaded& l) {
  std::int64_t surface = 0;
  for (std::size_t i = 0; i < l.pixels(); ++i) {
    const double length = glm::length(l.vector(l.g.normal, i)), coverage = l.coverage(i);
    ASSERT_TRUE(coverage >= 0 && coverage <= 1);
    ASSERT_NEAR(length, coverage > 0 ? 1 : 0, 1e-6);
    surface += coverage > 0;
    for (const auto& [role, range] : l.g.roles)
      for (int c = 0; c < range.count; ++c) ASSERT_TRUE(std::isfinite(l.g.planes.plane(range.first + c)[i])) << role;
  }
  EXPECT_EQ(surface, l.g.surface_pixels);
  EXPECT_GT(surface, std::int64_t(l.pixels()) / 20);
}

/// Pixels whose normal looks away from the viewer: the wrong space shows here.
double share_turned_away(const Loaded& l) {
  std::int64_t away = 0;
  for (std::size_t i = 0; i < l.pixels(); ++i) {
    if (l.coverage(i) == 0) continue;
    const Camera& camera = *l.reading.camera;
    const glm::dvec3 v = camera.projection == Camera::Projection::orthographic ? camera.backward() : camera.eye() - l.vector(l.g.position, i);
    away += glm::dot(v, l.vector(l.g.normal, i)) < 0;
  }
  return double(away) / double(l.g.surface_pixels);
}

TEST(GBuffer, EveryCaseOfTheCorpus) {
  for (const char* renderer : {"mitsuba", "blender", "pbrt"}) {
    NEEDS_CORPUS(renderer);
    for (const auto& entry : fs::directory_iterator(corpus / renderer)) {
      const fs::path file = entry.path() / "gbuffer.exr";
      if (!fs::exists(file)) continue;
      SCOPED_TRACE(file.string());
      const Loaded l(file, {"albedo"});
      check_plain(l);
      EXPECT_EQ(l.g.bad_pixels, 0);
      EXPECT_EQ(l.g.fractional_coverage, entry.path().filename().string().starts_with("aa64"));
      if (!l.reading.camera || entry.path().filename() == "onesided_back") continue;  // that one shows backs on purpose
      EXPECT_LT(share_turned_away(l), 0.05);
    }
  }
}

TEST(GBuffer, BlenderBackgroundAndBorder) {
  NEEDS_CORPUS("blender");
  const Loaded border(corpus / "blender/border/gbuffer.exr", {"coverage", "glossy_albedo"});
  const auto depth = channel(corpus / "blender/border/gbuffer.exr", "ViewLayer.Depth.Z");
  for (std::size_t i = 0; i < border.pixels(); ++i) EXPECT_EQ(border.coverage(i) > 0, depth[i] < 1e9f);
  EXPECT_EQ(border.g.roles.at("coverage").count, 1);
  EXPECT_EQ(border.g.roles.at("glossy_albedo").count, 3);
}

TEST(GBuffer, PbrtCameraSpaceGoesToWorld) {
  NEEDS_CORPUS("pbrt");
  const Loaded l(corpus / "pbrt/diffuse-camera-f16/gbuffer.exr", {});
  EXPECT_EQ(share_turned_away(l), 0);
  // Seen again by the camera that it was taken to world with, each position falls on its own pixel.
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < l.pixels(); i += 7)
    if (l.coverage(i) > 0)
      sightings.push_back(
          {double(i % std::size_t(l.g.window.width())) + 0.5, double(i / std::size_t(l.g.window.width())) + 0.5, l.vector(l.g.position, i)});
  EXPECT_LT(fit_pose(*l.reading.camera, sightings).residual, 0.05);
}

TEST(GBuffer, BumpNormalsLeaveTheLocalFrame) {
  NEEDS_CORPUS("mitsuba");
  const Loaded l(corpus / "mitsuba/bumpmap/gbuffer.exr", {});
  double lean = 0;
  for (std::size_t i = 0; i < l.pixels(); ++i)
    if (l.coverage(i) > 0) lean += glm::dot(l.vector(l.g.normal, i), l.vector(l.g.base_normal, i));
  EXPECT_GT(lean / double(l.g.surface_pixels), 0.95) << "bumps lean around the surface's own normal";
}

void check_coverage(const std::string& name, double worst_allowed, double mean_allowed) {
  SCOPED_TRACE(name);
  const Loaded l(corpus / "mitsuba" / name / "gbuffer.exr", {"ids", "albedo"});
  const auto truth = channel(corpus / "mitsuba" / name / "reference.exr", "A");
  double worst = 0, sum = 0;
  for (std::size_t i = 0; i < l.pixels(); ++i) {
    const double off = std::abs(l.coverage(i) - truth[i]);
    worst = std::max(worst, off);
    sum += off;
  }
  std::cout << name << ": coverage off by at most " << worst << ", " << sum / double(l.pixels()) << " in the mean\n";
  EXPECT_LT(worst, worst_allowed);
  EXPECT_LT(sum / double(l.pixels()), mean_allowed);
  std::set<std::uint32_t> ids;
  for (std::size_t i = 0; i < l.pixels(); ++i)
    if (l.coverage(i) > 0) ids.insert(l.g.ids[i]);
  EXPECT_EQ(ids.size(), name == "aa64_gaussian" ? 6u : 4u);
  EXPECT_EQ(*ids.begin(), 1u);
}

TEST(GBuffer, CoverageOfFilteredFiles) {
  NEEDS_CORPUS("mitsuba");
  check_coverage("aa64_gaussian", 1e-3, 1e-5);    // stored in image.A
  check_coverage("aa64_box_glossy", 0.02, 1e-4);  // written as 0: found from ids and normals
}

TEST(GBuffer, FilteredPositionsLieOnTheirSpheres) {
  NEEDS_CORPUS("mitsuba");
  const Loaded l(corpus / "mitsuba/aa64_box_glossy/gbuffer.exr", {"ids"});
  const glm::dvec3 centres[] = {{-1, 1, 0.044}, {1, 1, -0.099}, {-1, -1, -0.029}, {1, -1, 0.049}};
  for (std::size_t i = 0; i < l.pixels(); ++i) {
    if (l.coverage(i) == 0) continue;
    EXPECT_NEAR(glm::distance(l.vector(l.g.position, i), centres[l.g.ids[i] - 1]), 0.8, 0.03);
  }
}

TEST(GBuffer, BandsAgreeWithTheWhole) {
  NEEDS_CORPUS("mitsuba");
  for (const char* name : {"mitsuba/aa64_box_glossy", "mitsuba/bumpmap", "pbrt/diffuse-crop-f16"}) {
    const Loaded whole(corpus / name / "gbuffer.exr", {"albedo"});
    const Window all = whole.g.window;
    for (int row = all.min_y; row < all.max_y; row += 13) {
      const Window band{all.min_x + 5, row, all.max_x - 9, std::min(row + 13, all.max_y)};
      const GBuffer part = read_gbuffer(whole.file, whole.reading, band, {"albedo"}, 0);
      for (int plane = 0; plane < part.planes.count(); ++plane)
        for (int y = band.min_y; y < band.max_y; ++y)
          for (int x = band.min_x; x < band.max_x; ++x)
            ASSERT_EQ(part.planes.plane(plane)[(y - band.min_y) * band.width() + x - band.min_x],
                      whole.g.planes.plane(plane)[(y - all.min_y) * all.width() + x - all.min_x])
                << name << " plane " << plane << " at " << x << "," << y;
    }
  }
}

/// 16 x 16: a slanted, curved surface over the left 12 columns, nothing to the right.
double made_up(const std::string& channel, int x, int y) {
  if (x >= 12) return 0;
  if (channel == "ids") return 4000000000.0 + x;
  if (channel == "P.X") return x;
  if (channel == "P.Y") return y;
  if (channel == "P.Z") return 0.01 * x * x;
  return channel == "N.Z" ? 3 : channel == "N.X" ? 4 : 0;
}

const std::vector<std::string> plain{"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "ids:uint"};

TEST(GBuffer, WholeNumberIdsStayExactAndNormalsBecomeUnit) {
  const MadeUpExr made({{"", "", plain}}, 16, 16, made_up);
  const Loaded l(made.file, {"ids"});
  EXPECT_EQ(l.g.surface_pixels, 16 * 12);
  EXPECT_EQ(l.g.ids[11], 4000000011u);
  EXPECT_NEAR(l.vector(l.g.normal, 0).x, 0.8, 1e-7);
  EXPECT_EQ(l.vector(l.g.normal, 12), glm::dvec3(0));
  EXPECT_FALSE(l.g.fractional_coverage);
}

TEST(GBuffer, NotANumberIsNoSurface) {
  const MadeUpExr made({{"", "", {"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "albedo.R", "albedo.G", "albedo.B"}}}, 16, 16,
                       [](const std::string& channel, int x, int y) {
                         if (channel == "P.Y" && x == 3 && y == 5) return std::numeric_limits<double>::infinity();
                         if (channel == "N.Z" && x == 4 && y == 5) return std::numeric_limits<double>::quiet_NaN();
                         if (channel == "albedo.G" && x == 5 && y == 5) return std::numeric_limits<double>::quiet_NaN();
                         return channel.starts_with("albedo") ? 0.5 : made_up(channel, x, y);
                       });
  const Loaded l(made.file, {"albedo"});
  EXPECT_EQ(l.g.bad_pixels, 2);
  EXPECT_EQ(l.g.surface_pixels, 16 * 12 - 2);
  for (std::size_t i : {5 * 16 + 3, 5 * 16 + 4}) {
    EXPECT_EQ(l.coverage(i), 0);
    EXPECT_EQ(l.vector(l.g.position, i), glm::dvec3(0));
    EXPECT_EQ(l.vector(l.g.normal, i), glm::dvec3(0));
  }
  EXPECT_EQ(l.vector(l.g.roles.at("albedo"), 5 * 16 + 5), glm::dvec3(0.5, 0, 0.5));
}

TEST(GBuffer, UnsignedNormalsAreDecoded) {
  const MadeUpExr made({{"", "", {"N.R", "N.G", "N.B", "P.X", "P.Y", "P.Z"}}}, 16, 16, [](const std::string& channel, int x, int y) {
    if (!channel.starts_with("N")) return made_up(channel, x, y);
    return x >= 12 ? 0 : channel == "N.R" ? 0.9 : channel == "N.G" ? 0.5 : 0.8;
  });
  ReadingOptions options;
  options.normal_encoding = NormalEncoding::as_unsigned;
  options.normal_space = Space::world;  // one normal everywhere agrees with no surface: its space cannot be found out
  options.normal_axes = Axes{};
  const Loaded l(made.file, {}, options);
  EXPECT_NEAR(l.vector(l.g.normal, 0).x, 0.8, 1e-6);
  EXPECT_NEAR(l.vector(l.g.normal, 0).z, 0.6, 1e-6);
  EXPECT_EQ(l.g.surface_pixels, 16 * 12);
}

/// A component of -1 is stored as 0, which is not "no normal" while the others are not 0 as well.
TEST(GBuffer, UnsignedNormalsAlongAnAxisStayWhereLayersAreMeans) {
  const MadeUpExr made({{"", "", {"N.R", "N.G", "N.B", "P.X", "P.Y", "P.Z", "id"}}}, 16, 16, [](const std::string& channel, int x, int y) {
    if (channel == "id") return x == 3 ? 1.5 : 1.0;  // a mean of ids
    if (!channel.starts_with("N")) return made_up(channel, x, y);
    return channel == "N.R" ? 0.0 : 0.5;
  });
  ReadingOptions options;
  options.normal_encoding = NormalEncoding::as_unsigned;
  options.normal_space = Space::world;
  options.normal_axes = Axes{};
  options.premultiplied = true;
  const Loaded l(made.file, {"ids"}, options);
  EXPECT_EQ(l.vector(l.g.normal, 0), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(l.g.surface_pixels, 16 * 16);
  EXPECT_EQ(l.g.ids[3], 1u);
}

}  // namespace
}  // namespace relume
