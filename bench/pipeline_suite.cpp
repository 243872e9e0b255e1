// Subjects pipeline/<size>/<lights>/<device>: a file relit as `relume shade` does it, from EXR to EXR, with its stages, beside a mere copy of the
// file.
#include <stdlib.h>

#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/ground_frame.h"
#include "bench/plain_copy.h"
#include "bench/suites.h"
#include "gbuffer/error.h"
#include "host/relight.h"

namespace relume::bench {
namespace {

/// A folder that goes with the last subject that needs it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "relume-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error(ErrorKind::output, name + ": no temporary folder can be made (TMPDIR names another place)");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// 13 half channels, ZIP: what a renderer writes.
void write_frame(const std::filesystem::path& file, Size size) {
  const GBuffer frame = ground_source(size.width, size.height).make({"albedo", "roughness", "ks"}, 0);
  const std::vector<std::pair<PlaneRange, std::vector<std::string>>> layers{{frame.position, {"P.X", "P.Y", "P.Z"}},
                                                                            {frame.normal, {"N.X", "N.Y", "N.Z"}},
                                                                            {frame.roles.at("albedo"), {"albedo.R", "albedo.G", "albedo.B"}},
                                                                            {frame.roles.at("roughness"), {"roughness"}},
                                                                            {frame.roles.at("ks"), {"other.R", "other.G", "other.B"}}};
  std::vector<std::string> channels;
  std::vector<Source> sources;
  for (const auto& [range, names] : layers)
    for (std::size_t c = 0; c < names.size(); ++c) {
      channels.push_back(names[c]);
      sources.push_back({names[c], frame.planes.plane(range.first + int(c)), sizeof(float), sizeof(float) * std::size_t(size.width)});
    }
  ExrWriter writer(file, {SampleType::half_float, "zip", true}, Imf::Header(size.width, size.height), frame.window, frame.window, channels, {});
  writer.write_rows(size.height, sources);
  writer.commit();
}

void write_rig(const std::filesystem::path& file, const Camera& camera, int lights) {
  nlohmann::json rig{{"relume", 1}, {"lights", nlohmann::json::array()}};
  std::vector<double> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix.push_back(camera.world_from_camera[column][row]);
  rig["camera"] = {{"world_from_camera", matrix}, {"vertical_fov", 40}};
  for (const Light& l : ground_lights(LightType::point, lights))
    rig["lights"].push_back(
        {{"type", "point"}, {"position", {l.position.x, l.position.y, l.position.z}}, {"intensity", {l.intensity.x, l.intensity.y, l.intensity.z}}});
  std::ofstream(file) << rig;
}

/// Seconds of every go, by stage in their order.
struct Stages {
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> seconds;

  void add(const RelightSummary& summary) {
    for (const auto& [stage, value] : summary.seconds) {
      if (!seconds.contains(stage)) order.push_back(stage);
      seconds[stage].push_back(value);
    }
  }
};

RelightJob job_of(const Folder& folder, const std::string& rig, const std::string& device) {
  RelightJob job;
  job.gbuffer = folder / "frame.exr";
  job.output = folder / "out.exr";
  job.rigs = {folder / rig};
  job.format = {SampleType::half_float, "zip", true};
  job.device = device;
  return job;
}

/// What a stage took of the goes that were measured: the last ones.
Measurement stage_of(const Measurement& whole, const Stages& stages, const std::string& stage) {
  const std::vector<double>& all = stages.seconds.at(stage);
  const std::size_t measured = std::min(all.size(), whole.seconds.size() * std::size_t(whole.goes));
  const std::vector<double> seconds(all.end() - std::ptrdiff_t(measured), all.end());
  return {{whole.subject.name + "/" + stage, {}, {}, {}, {}}, seconds, seconds, 1};
}

constexpr int light_counts[] = {8, 64};

Group group_of(const BenchDevice& device, Size size) {
  const std::string prefix = "pipeline/" + std::to_string(size.width) + "x" + std::to_string(size.height) + "/", copy = prefix + "copy";
  const auto stages = std::make_shared<std::map<std::string, Stages>>();
  const auto name_of = [=, label = device.label](int lights) { return prefix + std::to_string(lights) + "/" + label; };
  Group group;
  group.names = {copy};
  for (const int lights : light_counts) {
    group.names.push_back(name_of(lights));
    group.claims.push_back({Measure::time_over, name_of(lights), copy, "in times of a mere copy", lights == 8 ? 1.2 : 1.5});
  }
  group.make = [&device, size, copy, stages, name_of](const std::function<bool(const std::string&)>& is_wanted) {
    const auto folder = std::make_shared<Folder>();
    write_frame(*folder / "frame.exr", size);
    std::vector<Subject> made;
    if (is_wanted(copy)) made.push_back({copy, [=] { copy_exr(*folder / "frame.exr", *folder / "copy.exr"); }, {}, {}, {}});
    for (const int lights : light_counts) {
      const std::string name = name_of(lights);
      if (!is_wanted(name)) continue;
      const std::string rig = std::to_string(lights) + ".json";
      write_rig(*folder / rig, ground_source(1, 1).camera, lights);
      Work work;
      work.pixel_lights = {{"brute", double(size.width) * size.height * lights}};
      const auto run = [=, job = job_of(*folder, rig, device.selector)] {
        (void)folder;  // kept as long as it is written to
        (*stages)[name].add(relight(job, {}));
      };
      made.push_back({name, run, work, {}, {}});
    }
    return made;
  };
  group.finish = [stages](std::vector<Measurement>& measured) {
    for (const Measurement& whole : std::vector(measured))
      for (const std::string& stage : (*stages)[whole.subject.name].order) measured.push_back(stage_of(whole, (*stages)[whole.subject.name], stage));
  };
  return group;
}

}  // namespace

std::vector<Group> pipeline_groups(const Bench& bench) {
  std::vector<Group> groups;
  for (const BenchDevice& device : bench.devices)
    groups.push_back(group_of(device, bench.options.sizes.empty() ? Size{1920, 1080} : bench.options.sizes.front()));
  return groups;
}

}  // namespace relume::bench
