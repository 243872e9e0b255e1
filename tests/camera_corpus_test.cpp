// Every position layer of the corpus: the camera recovered from it alone, its reprojection error, and each camera that a header states against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/reading.h"
#include "gbuffer/sample_rows.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path corpus() {
  const fs::path beside = RELUME_CORPUS;
  return fs::exists(beside / "blender") ? beside : fs::path(RELUME_SOURCE) / "tests/data/corpus";
}

json read_json(const fs::path& file) { return json::parse(std::ifstream(file)); }

std::vector<fs::path> gbuffers_of(const std::string& renderer) {
  std::vector<fs::path> files;
  if (!fs::exists(corpus() / renderer)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(corpus() / renderer))
    if (entry.path().extension() == ".exr" && entry.path().filename().string().starts_with("gbuffer")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Sighting> sightings_of(const ExrFile& file, const Reading& reading) {
  std::vector<glm::dvec3> normals;
  return clear_sightings(sample_rows(file, reading, {"position", "normal", "depth", "coverage"}), reading, normals);
}

bool half_positions(const Reading& reading) {
  const auto& types = reading.roles.at("position").types;
  return std::any_of(types.begin(), types.end(), [](SampleType type) { return type == SampleType::half_float; });
}

/// What was measured of one file; printed as a row.
struct Row {
  std::string name, header;
  bool half = false, planar = false;
  std::size_t sightings = 0;
  double recovered = -1;  ///< pixels, with the camera's own lens

  double limit() const { return half ? 0.5 : 0.05; }
  void print() const {
    std::printf("%-44s %-5s %5zu  ", name.c_str(), half ? "half" : "float", sightings);
    std::printf(planar ? "one plane" : "%9.5f", recovered);
    std::printf("  %s\n", header.c_str());
  }
};

/// Where the positions are in camera space, the header's pose cannot be asked, but its lens can.
Camera where_positions_are(Camera camera, const Reading& reading) {
  if (reading.position_space == Space::world) return camera;
  camera.world_from_camera = glm::dmat4(1);
  if (reading.position_axes.sign[2] < 0) camera.world_from_camera[2] *= -1.0;
  return camera;
}

/// "verified" by less than half a pixel, or "contradicted": the pose with the best lens, and the header's own lens where it states one.
std::string verdict_on(const Camera& stated, const Reading& reading, const std::vector<Sighting>& sightings) {
  const Camera camera = where_positions_are(stated, reading);
  const double pose = fit_pose(camera, sightings).residual, lens = reprojection_error(camera, sightings);
  char text[96];
  std::snprintf(text, sizeof text, "%s: pose %.4f px, with its lens %s", pose < 0.5 ? "verified" : "contradicted", pose,
                camera.lens ? std::to_string(lens).substr(0, 6).c_str() : "(none)");
  return text;
}

Row measure(const std::string& name, const ExrFile& file, const Reading& reading) {
  const auto sightings = sightings_of(file, reading);
  Row row{name, "", half_positions(reading), false, sightings.size(), -1};
  const Recovery recovery = recover(sightings, reading.display_window);
  row.planar = !recovery.camera && recovery.why_not.find("plane") != std::string::npos;
  EXPECT_TRUE(recovery.camera || row.planar) << name << ": " << recovery.why_not;
  if (recovery.camera) {
    row.recovered = reprojection_error(*recovery.camera, sightings);
    EXPECT_EQ(row.recovered, recovery.camera->residual) << name << ": the residual is that of the camera that is handed out";
    EXPECT_LT(row.recovered, row.limit()) << name;
  }
  const auto stated = header_cameras(file, reading.part, reading.display_window);
  if (!stated.empty()) row.header = verdict_on(stated.front(), reading, sightings) + "  (" + stated.front().source + ")";
  row.print();
  return row;
}

TEST(CameraCorpus, RendererFiles) {
  int files = 0, planar = 0;
  for (const char* renderer : {"blender", "mitsuba", "pbrt"})
    for (const fs::path& path : gbuffers_of(renderer)) {
      const ExrFile file(path);
      const Row row = measure(fs::relative(path, corpus()), file, understand(file, {}));
      ++files;
      planar += row.planar;
      if (row.header.empty()) continue;
      EXPECT_TRUE(row.header.starts_with("verified")) << row.name;
    }
  EXPECT_GE(files, 7);  // those that the project keeps
  EXPECT_LT(5 * planar, files) << "few scenes are a plane";
}

/// The layers as the answer file names them: this test asks for cameras, not for names.
RoleLayer role_of(const ExrFile& file, const json& layer) {
  RoleLayer role;
  role.channels = layer["channels"].get<std::vector<std::string>>();
  const std::string part = layer.value("part", "");
  for (const Part& p : file.parts())
    if (part.empty() || p.name == part) role.part = p.index;
  role.types.assign(role.channels.size(), layer["type"] == "float16" ? SampleType::half_float : SampleType::float32);
  return role;
}

Reading reading_of(const ExrFile& file, const json& answer) {
  Reading reading;
  for (const char* role : {"position", "normal"})
    if (answer["layers"].contains(role)) reading.roles[role] = role_of(file, answer["layers"][role]);
  if (answer["layers"].contains("beauty") && answer["layers"]["beauty"]["channels"].size() == 4) {
    json alpha = answer["layers"]["beauty"];
    alpha["channels"] = json::array({alpha["channels"][3]});
    reading.roles["coverage"] = role_of(file, alpha);
  }
  if (reading.roles.contains("position")) {
    const json& position = answer["layers"]["position"];
    reading.part = reading.roles["position"].part;
    reading.position_premultiplied = position.value("premultiplied", false);
    reading.position_space = position["space"] == "world" ? Space::world : Space::camera;
    if (position["space"] == "camera_forward") reading.position_axes.sign[2] = -1;
  }
  if (answer["layers"]["normal"].value("encoding", "") == "unsigned") reading.normal_encoding = NormalEncoding::as_unsigned;
  const Part& part = file.parts()[std::size_t(reading.part)];
  reading.data_window = part.data_window;
  reading.display_window = part.display_window;
  return reading;
}

/// The answer's camera, in the file's own world.
Camera truth_of(const json& answer, const Reading& reading) {
  Camera camera;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) camera.world_from_camera[c][r] = answer["camera"]["world_from_camera"][std::size_t(r)][std::size_t(c)];
  const double scale = 0.5 * reading.display_window.width() / std::tan(answer["camera"]["fov_horizontal_deg"].get<double>() * M_PI / 360);
  camera.lens = Lens{scale, scale, 0.5 * reading.display_window.width(), 0.5 * reading.display_window.height()};
  return camera;
}

/// As a share of the eye's distance from the scene's middle, and the axes.
void expect_same(const Camera& found, const Camera& truth, double tolerance, const std::string& name) {
  EXPECT_LT(glm::distance(found.eye(), truth.eye()), tolerance * glm::length(truth.eye())) << name << " eye";
  for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(found.world_from_camera[c], truth.world_from_camera[c]), tolerance) << name << " axis " << c;
}

void expect_same_lens(const Camera& found, const Camera& truth, double tolerance, const std::string& name) {
  ASSERT_TRUE(found.lens) << name;
  EXPECT_NEAR(found.lens->scale_x / truth.lens->scale_x, 1, tolerance) << name;
  EXPECT_NEAR(found.lens->scale_y / truth.lens->scale_y, 1, tolerance) << name;
  EXPECT_NEAR(found.lens->centre_x, truth.lens->centre_x, tolerance * truth.lens->scale_x) << name;
  EXPECT_NEAR(found.lens->centre_y, truth.lens->centre_y, tolerance * truth.lens->scale_x) << name;
}

TEST(CameraCorpus, ConventionFiles) {
  if (!fs::exists(corpus() / "conventions")) GTEST_SKIP() << "the corpus is not beside the project";
  int recovered = 0, stated_right = 0;
  for (const auto& entry : fs::directory_iterator(corpus() / "conventions")) {
    if (!entry.path().filename().string().ends_with(".answer.json")) continue;
    const json answer = read_json(entry.path());
    const std::string name = answer["file"];
    const ExrFile file(corpus() / "conventions" / name);
    const Reading reading = reading_of(file, answer);
    const Camera truth = truth_of(answer, reading);
    const auto stated = header_cameras(file, reading.part, reading.display_window);
    ASSERT_EQ(!stated.empty(), answer["camera"]["in_header"].get<bool>()) << name;
    if (!stated.empty()) {
      expect_same(stated.front(), truth, 1e-4, name + ": " + stated.front().source);
      expect_same_lens(stated.front(), truth, 1e-4, name);
      ++stated_right;
    }
    if (!reading.roles.contains("position")) {
      std::printf("%-44s no positions  %s\n", name.c_str(), stated.empty() ? "" : stated.front().source.c_str());
      continue;
    }
    const Row row = measure(name, file, reading);
    EXPECT_TRUE(row.header.empty() || row.header.starts_with("verified")) << name;
    if (reading.position_space != Space::world) continue;
    const auto camera = recover_camera(sightings_of(file, reading), reading.display_window);
    ASSERT_TRUE(camera) << name;
    expect_same(*camera, truth, row.half ? 5e-3 : 1e-3, name + " recovered");
    expect_same_lens(*camera, truth, row.half ? 5e-3 : 1e-3, name + " recovered");
    ++recovered;
  }
  EXPECT_GE(recovered, 3);  // those that the project keeps
  EXPECT_GE(stated_right, 3);
}

}  // namespace
}  // namespace relume
