// relume inspect: what was understood of a file, on what evidence, and how to overrule it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/reading_arguments.h"
#include "gbuffer/error.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(SampleType type) { return type == SampleType::half_float ? "half" : type == SampleType::float32 ? "float" : "uint"; }
const char* name_of(Space space) { return space == Space::world ? "world" : "camera"; }

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

/// Range of each role's planes over surface pixels, and what is not finite.
Json range_json(const GBuffer& gbuffer, const PlaneRange& range) {
  const float* coverage = gbuffer.planes.plane(gbuffer.coverage.first);
  Json lowest = Json::array(), highest = Json::array();
  std::int64_t bad = 0;
  for (int c = 0; c < range.count; ++c) {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    const float* plane = gbuffer.planes.plane(range.first + c);
    for (std::int64_t i = 0; i < gbuffer.window.pixels(); ++i) {
      if (coverage[i] <= 0) continue;
      if (!std::isfinite(plane[i])) {
        ++bad;
        continue;
      }
      low = std::min(low, plane[i]);
      high = std::max(high, plane[i]);
    }
    lowest.push_back(low <= high ? Json(low) : Json());
    highest.push_back(low <= high ? Json(high) : Json());
  }
  return {{"lowest", lowest}, {"highest", highest}, {"not_finite", bad}};
}

Json roles_json(const ExrFile& file, const Reading& reading) {
  std::vector<std::string> roles;
  for (const auto& [role, layer] : reading.roles)
    if (role != "position" && role != "normal" && role != "base_normal" && role != "ids") roles.push_back(role);
  const GBuffer gbuffer = read_gbuffer(file, reading, reading.data_window, roles, 0);
  Json json;
  for (const auto& [role, layer] : reading.roles) {
    Json& entry = json[role] = {{"layer", layer.layer}, {"part", layer.part}, {"channels", layer.channels}};
    Json types = Json::array();
    for (const SampleType type : layer.types) types.push_back(name_of(type));
    entry["types"] = types;
    const auto planes = gbuffer.roles.find(role);
    if (role == "position") entry.update(range_json(gbuffer, gbuffer.position));
    if (role == "normal") entry.update(range_json(gbuffer, gbuffer.normal));
    if (planes != gbuffer.roles.end()) entry.update(range_json(gbuffer, planes->second));
  }
  return {{"roles", json},
          {"surface_pixels", gbuffer.surface_pixels},
          {"pixels", gbuffer.window.pixels()},
          {"bad_pixels", gbuffer.bad_pixels},
          {"filtered", gbuffer.fractional_coverage}};
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

Json inspect_json(const ExrFile& file, const Reading& reading) {
  Json json{{"file", file.path().string()}, {"convention", reading.convention}, {"evidence", reading.evidence}, {"parts", parts_json(file)}};
  json.update(roles_json(file, reading));
  json["position_space"] = name_of(reading.position_space);
  json["normal_space"] = name_of(reading.normal_space);
  json["normal_encoding"] = reading.normal_encoding == NormalEncoding::as_signed ? "signed" : "unsigned";
  json["default_lobes"] = {reading.default_diffuse, reading.default_specular};
  json["camera"] = reading.camera ? camera_json(*reading.camera) : Json();
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
  std::printf("%s: %d x %d, %zu part(s), %lld of %lld pixels show a surface\n", text(j["file"]).c_str(), window["x1"].get<int>() - window["x0"].get<int>(),
              window["y1"].get<int>() - window["y0"].get<int>(), j["parts"].size(), j["surface_pixels"].get<long long>(), j["pixels"].get<long long>());
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
