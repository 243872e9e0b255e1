// InspectedObjects: counts, then JSON, then lines for people.
#include "cli/inspect_objects.h"

#include <algorithm>
#include <cstdio>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

std::string hexadecimal(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", id);
  return text;
}

Json object_json(const ObjectIds& layer, std::uint32_t id, const ObjectCount& count) {
  Json object;
  const auto name = layer.manifest().names.find(id);
  if (name != layer.manifest().names.end()) object["name"] = name->second;
  object["id"] = layer.is_cryptomatte() ? Json(hexadecimal(id)) : Json(id);
  object["pixels"] = count.pixels;
  object["coverage"] = count.coverage;
  return object;
}

/// Those that fill most pixels first; then those that only the manifest knows.
Json objects_json(const ObjectIds& layer, const ObjectCounts& counts) {
  std::vector<std::pair<std::uint32_t, ObjectCount>> sorted(counts.begin(), counts.end());
  for (const auto& [id, name] : layer.manifest().names)
    if (!counts.contains(id)) sorted.push_back({id, {}});
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second.pixels > b.second.pixels; });
  Json objects = Json::array();
  for (const auto& [id, count] : sorted) objects.push_back(object_json(layer, id, count));
  return objects;
}

void print_layer(const Json& layer) {
  constexpr std::size_t shown = 8;  // as many as a line or two hold
  const Json& objects = layer["objects"];
  std::string text;
  std::size_t i = 0;
  for (; i < std::min(shown, objects.size()) && objects[i]["pixels"] > 0; ++i) {
    const Json& id = objects[i]["id"];
    const std::string called = objects[i].contains("name") ? printable(objects[i]["name"].get<std::string>())
                               : id.is_string()            ? id.get<std::string>()
                                                           : std::to_string(id.get<std::uint32_t>());
    text += (i ? ", " : "") + called + ' ' + std::to_string(objects[i]["pixels"].get<std::int64_t>());
  }
  if (objects.size() > i) text += (i ? ", and " : "") + std::to_string(objects.size() - i) + " more (--json lists them)";
  const std::string manifest = layer.value("manifest", "");
  const std::string kind = layer["kind"] == "ids" ? std::string("ids")
                                                  : "Cryptomatte of " + std::to_string(layer["ranks"].get<std::size_t>()) + " ranks, " +
                                                        (manifest.empty() ? "no manifest" : "names from " + printable(manifest));
  std::printf("objects       %s (%s), pixels: %s\n", printable(layer["layer"].get<std::string>()).c_str(), kind.c_str(),
              text.empty() ? "none" : text.c_str());
}

}  // namespace

InspectedObjects::InspectedObjects(const ExrFile& file, Reading& reading) {
  for (const Cryptomatte& cryptomatte : cryptomattes_of(file, reading)) {
    if (cryptomatte.defect.empty())
      layers_.push_back({ObjectIds(file, reading, cryptomatte.name, true), {}});
    else
      unusable_.push_back({{"layer", cryptomatte.name}, {"kind", "cryptomatte"}, {"defect", cryptomatte.defect}});
  }
  if (!reading.roles.contains("ids")) return;
  try {
    reading.ids_cryptomatte.clear();
    layers_.push_back({ObjectIds(file, reading, "", false), {}});
  } catch (const Error& error) {
    unusable_.push_back({{"layer", reading.roles.at("ids").layer}, {"kind", "ids"}, {"defect", error.what()}});
  }
}

std::vector<std::string> InspectedObjects::roles() const {
  std::vector<std::string> roles;
  for (const Counted& counted : layers_) roles.insert(roles.end(), counted.layer.roles().begin(), counted.layer.roles().end());
  return roles;
}

void InspectedObjects::add(const GBuffer& gbuffer) {
  for (Counted& counted : layers_) counted.layer.count(gbuffer, counted.counts);
}

Json InspectedObjects::json() const {
  Json layers = Json::array();
  for (const auto& [layer, counts] : layers_) {
    Json entry{{"layer", layer.name()}, {"kind", layer.is_cryptomatte() ? "cryptomatte" : "ids"}};
    if (layer.is_cryptomatte()) entry.update({{"ranks", layer.ranks()}, {"manifest", layer.manifest().source}});
    entry["objects"] = objects_json(layer, counts);
    entry["notes"] = layer.notes();
    layers.push_back(entry);
  }
  for (const Json& entry : unusable_) layers.push_back(entry);
  return layers;
}

void print_objects(const Json& layers) {
  for (const Json& layer : layers) {
    if (layer.contains("defect"))
      std::printf("objects       %s: unusable: %s\n", printable(layer["layer"].get<std::string>()).c_str(),
                  printable_sentence(layer["defect"].get<std::string>()).c_str());
    else
      print_layer(layer);
    for (const Json& note : layer.value("notes", Json::array()))
      std::printf("note          %s\n", printable_sentence(note.get<std::string>()).c_str());
  }
}

}  // namespace relume
