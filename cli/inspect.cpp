// relume inspect: what was understood of a file, on what evidence, and how to overrule it.
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/inspect_objects.h"
#include "cli/reading_arguments.h"
#include "gbuffer/error.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

Json window_json(const Window& w) { return {{"x0", w.min_x}, {"y0", w.min_y}, {"x1", w.max_x}, {"y1", w.max_y}}; }

Json camera_json(const Camera& camera) {
  const glm::dvec3 eye = camera.eye(), backward = camera.backward();
  Json json{{"projection", camera.projection == Camera::Projection::orthographic ? "orthographic" : "perspective"},
            {"source", camera.source},
            {"eye", {eye.x, eye.y, eye.z}},
            {"forward", {-backward.x, -backward.y, -backward.z}}};
  if (camera.vertical_fov > 0) json["vertical_fov"] = camera.vertical_fov;
  if (camera.height > 0) json["height"] = camera.height;
  if (camera.residual >= 0) json["residual_px"] = camera.residual;
  return json;
}

/// The range of one component's values over surface pixels.
struct Extent {
  float lowest = std::numeric_limits<float>::infinity(), highest = -std::numeric_limits<float>::infinity();
  std::int64_t not_finite = 0;

  void add(float value) {
    if (!std::isfinite(value)) {
      ++not_finite;
      return;
    }
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  Extent with(const Extent& other) const { return {std::min(lowest, other.lowest), std::max(highest, other.highest), not_finite + other.not_finite}; }
};

Extent extent_of(const float* plane, const float* coverage, std::int64_t pixels) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(0, pixels, 1 << 15), Extent{},
      [=](const auto& range, Extent extent) {
        for (std::int64_t i = range.begin(); i < range.end(); ++i)
          if (coverage[i] > 0) extent.add(plane[i]);
        return extent;
      },
      [](const Extent& a, const Extent& b) { return a.with(b); });
}

/// The ranges of one role's components, gathered band by band.
struct Range {
  std::vector<Extent> components;

  void add(const GBuffer& gbuffer, const PlaneRange& range) {
    components.resize(std::size_t(range.count));
    const float* const coverage = gbuffer.planes.plane(gbuffer.coverage.first);
    for (int c = 0; c < range.count; ++c) {
      Extent& extent = components[std::size_t(c)];
      extent = extent.with(extent_of(gbuffer.planes.plane(range.first + c), coverage, gbuffer.window.pixels()));
    }
  }

  Json json() const {
    Json low = Json::array(), high = Json::array();
    std::int64_t not_finite = 0;
    for (const Extent& extent : components) {
      const bool any = extent.lowest <= extent.highest;
      low.push_back(any ? Json(extent.lowest) : Json());
      high.push_back(any ? Json(extent.highest) : Json());
      not_finite += extent.not_finite;
    }
    return {{"lowest", low}, {"highest", high}, {"not_finite", not_finite}};
  }
};

/// What the pixels show, over the whole data window.
struct Contents {
  std::map<std::string, Range> ranges;  ///< by role
  std::int64_t surface_pixels = 0, bad_pixels = 0;
  bool filtered = false;
  Json objects;
};

Contents contents_of(const ExrFile& file, Reading reading) {
  std::vector<std::string> roles;
  for (const auto& [role, layer] : reading.roles)
    if (role != "position" && role != "normal" && role != "base_normal" && role != "ids") roles.push_back(role);
  Contents contents;
  InspectedObjects objects(file, reading);
  for (const std::string& role : objects.roles()) roles.push_back(role);
  const Window& all = reading.data_window;
  const int rows = std::max(1, (1 << 22) / std::max(1, all.width()));  // four million pixels: a few hundred megabytes of planes
  for (int top = all.min_y; top < all.max_y; top += rows) {
    const GBuffer gbuffer = read_gbuffer(file, reading, {all.min_x, top, all.max_x, std::min(top + rows, all.max_y)}, roles, 0);
    contents.ranges["position"].add(gbuffer, gbuffer.position);
    contents.ranges["normal"].add(gbuffer, gbuffer.normal);
    for (const auto& [role, planes] : gbuffer.roles)
      if (!role.starts_with(cryptomatte_role)) contents.ranges[role].add(gbuffer, planes);
    objects.add(gbuffer);
    contents.surface_pixels += gbuffer.surface_pixels;
    contents.bad_pixels += gbuffer.bad_pixels;
    contents.filtered = contents.filtered || gbuffer.fractional_coverage;
  }
  contents.objects = objects.json();
  return contents;
}

Json roles_json(const ExrFile& file, const Reading& reading) {
  const Contents contents = contents_of(file, reading);
  Json json;
  for (const auto& [role, layer] : reading.roles) {
    Json& entry = json[role] = {{"layer", layer.layer}, {"part", layer.part}, {"channels", layer.channels}};
    Json types = Json::array();
    for (const SampleType type : layer.types) types.push_back(name_of(type));
    entry["types"] = types;
    if (const auto range = contents.ranges.find(role); range != contents.ranges.end()) entry.update(range->second.json());
  }
  return {{"roles", json},
          {"surface_pixels", contents.surface_pixels},
          {"pixels", reading.data_window.pixels()},
          {"bad_pixels", contents.bad_pixels},
          {"filtered", contents.filtered},
          {"objects", contents.objects}};
}

Json parts_json(const ExrFile& file) {
  Json parts = Json::array();
  for (const Part& part : file.parts()) {
    Json channels = Json::array();
    for (const Channel& channel : part.channels) channels.push_back({{"name", channel.name}, {"type", name_of(channel.type)}});
    parts.push_back({{"index", part.index},
                     {"name", part.name},
                     {"view", part.view},
                     {"data_window", window_json(part.data_window)},
                     {"display_window", window_json(part.display_window)},
                     {"channels", channels}});
  }
  return parts;
}

Json verdicts_json(const Reading& reading) {
  Json verdicts = Json::array();
  for (const Verdict& v : reading.verdicts)
    verdicts.push_back({{"question", v.question}, {"answer", v.answer}, {"sure", v.sure}, {"evidence", v.evidence}, {"option", v.option}});
  return verdicts;
}

Json inspect_json(const ExrFile& file, const Reading& reading) {
  Json json{{"file", file.path().string()}, {"convention", reading.convention}, {"evidence", reading.evidence}, {"parts", parts_json(file)}};
  json.update(roles_json(file, reading));
  json["position_space"] = name_of(reading.position_space);
  json["normal_space"] = name_of(reading.normal_space);
  json["normal_encoding"] = reading.normal_encoding == NormalEncoding::as_signed ? "signed" : "unsigned";
  json["default_lobes"] = {reading.default_diffuse, reading.default_specular};
  json["camera"] = reading.camera ? camera_json(*reading.camera) : Json();
  json["verdicts"] = verdicts_json(reading);
  json["made"] = reading.made;
  json["notes"] = reading.notes;
  return json;
}

std::string triple(const Json& values) {
  std::string text;
  for (const auto& v : values) {
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", v.is_null() ? NAN : v.get<double>());
    text += (text.empty() ? "" : " ") + std::string(number);
  }
  return text;
}

void print(const Json& j) {
  const auto text = [](const Json& value) { return printable(value.get<std::string>()); };
  const Json& window = j["parts"][0]["data_window"];
  std::printf("%s: %d x %d, %zu part(s), %lld of %lld pixels show a surface\n", text(j["file"]).c_str(),
              window["x1"].get<int>() - window["x0"].get<int>(), window["y1"].get<int>() - window["y0"].get<int>(), j["parts"].size(),
              j["surface_pixels"].get<long long>(), j["pixels"].get<long long>());
  std::printf("written by    %s, as %s (--convention NAME overrules)\n", text(j["convention"]).c_str(), text(j["evidence"]).c_str());
  for (const auto& [role, entry] : j["roles"].items()) {
    std::printf("%-16s %-22s %-5s", printable(role).c_str(), text(entry["layer"]).c_str(), text(entry["types"][0]).c_str());
    if (entry.contains("lowest")) std::printf("  %s .. %s", triple(entry["lowest"]).c_str(), triple(entry["highest"]).c_str());
    if (entry.value("not_finite", 0) > 0) std::printf("  %d not finite", entry["not_finite"].get<int>());
    std::printf("\n");
  }
  std::printf("position in %s space, normals in %s space, %s\n", text(j["position_space"]).c_str(), text(j["normal_space"]).c_str(),
              text(j["normal_encoding"]).c_str());
  if (j["camera"].is_null())
    std::printf("camera        none (--camera FILE names a rig, a glTF or another EXR)\n");
  else
    std::printf("camera        %s at %s looking along %s (%s)\n", text(j["camera"]["projection"]).c_str(), triple(j["camera"]["eye"]).c_str(),
                triple(j["camera"]["forward"]).c_str(), text(j["camera"]["source"]).c_str());
  std::printf("default lobes %s + %s\n", text(j["default_lobes"][0]).c_str(), text(j["default_lobes"][1]).c_str());
  if (j["bad_pixels"] > 0) std::printf("defect        %lld pixels with a NaN or infinite position or normal\n", j["bad_pixels"].get<long long>());
  print_objects(j["objects"]);
  for (const auto& v : j["verdicts"])
    std::printf("%-13s %s%s: %s (%s overrules)\n", text(v["question"]).c_str(), text(v["answer"]).c_str(), v["sure"] ? "" : ", not sure",
                printable_sentence(v["evidence"].get<std::string>()).c_str(), text(v["option"]).c_str());
  for (const auto& made : j["made"]) std::printf("made          %s\n", printable_sentence(made.get<std::string>()).c_str());
  for (const auto& note : j["notes"]) std::printf("note          %s\n", printable_sentence(note.get<std::string>()).c_str());
}

struct InspectArguments {
  std::string file;
  bool json = false;
  ReadingArguments reading;
};

int inspect(const InspectArguments& a) {
  const ExrFile file(a.file);
  const Json json = inspect_json(file, understand(file, a.reading.options()));
  if (a.json)
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  else
    print(json);
  return 0;
}

}  // namespace

void add_inspect(CLI::App& command, Action& action) {
  const auto a = std::make_shared<InspectArguments>();
  command.add_option("gbuffer", a->file, "an OpenEXR file")->required();
  command.add_flag("--json", a->json, "for programs");
  a->reading.add_to(command);
  command.footer("Example: relume inspect shot.exr");
  command.callback([a, &action] { action = [a] { return inspect(*a); }; });
}

}  // namespace relume
