// Cryptomattes found: by the header's metadata, else by their layers' names.
#include "gbuffer/cryptomatte.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "gbuffer/printable.h"
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

/// What names are compared by. Nuke writes '_' where Blender has '.'.
std::string plain(const std::string& name) {
  std::string text = normalised(name);
  std::erase(text, '.');
  return text;
}

constexpr std::size_t digits = 2;  // of a level, always two in files and in the specification: "Crypto200" is level 0 of "Crypto2"

bool ends_in_level(const std::string& name) {
  return name.size() > digits && std::all_of(name.end() - digits, name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string without_level(const std::string& name) { return ends_in_level(name) ? name.substr(0, name.size() - digits) : name; }

/// Where a header tells of a Cryptomatte.
struct Metadata {
  int part;
  std::string key, name;
};

using MetadataByName = std::map<std::string, Metadata>;

/// Of all parts, by plain name: Blender 5 tells of all Cryptomattes in the first part alone. Some programs keep the prefix that Nuke shows, "exr/".
MetadataByName metadata_of(const ExrFile& file) {
  MetadataByName all;
  for (const Part& part : file.parts())
    for (const std::string& attribute : attribute_names(part.header)) {
      const std::string folder = normalised(attribute);
      if (!folder.starts_with("cryptomatte/") && !folder.starts_with("exr/cryptomatte/")) continue;
      if (!folder.ends_with("/name")) continue;
      const auto name = text_attribute(part.header, attribute);
      if (name) all.try_emplace(plain(*name), Metadata{part.index, attribute.substr(0, attribute.size() - std::string_view("name").size()), *name});
    }
  return all;
}

/// Id and coverage of one or two ranks; no channels if the layer lacks them.
RoleLayer level_of(const Layer& layer) {
  RoleLayer level{layer.part, display_name(layer, false), {}, {}};
  for (const auto& [id, coverage] : {std::array{'r', 'g'}, std::array{'b', 'a'}}) {
    const Component *const first = layer.component(id), *const second = layer.component(coverage);
    if (!first || !second) break;
    for (const Component* component : {first, second}) {
      level.channels.push_back(component->channel);
      level.types.push_back(component->type);
    }
  }
  return level;
}

std::string defect_of(const RoleLayer& level) {
  for (std::size_t c = 0; c < level.channels.size(); c += 2)
    if (level.types[c] != SampleType::float32)
      return "channel \"" + printable(level.channels[c]) + "\" is " + (level.types[c] == SampleType::half_float ? "half" : "uint") +
             ": its ids are lost (a Cryptomatte's are the bits of 32-bit floats)";
  return {};
}

std::string value_of(const ExrFile& file, const Cryptomatte& cryptomatte, const char* what) {
  return text_attribute(file.parts()[std::size_t(cryptomatte.header_part)].header, cryptomatte.key + what).value_or("");
}

/// The Cryptomatte that a layer belongs to, with what the header says of it.
Cryptomatte begun(const ExrFile& file, const MetadataByName& metadata, const Layer& layer) {
  Cryptomatte cryptomatte{without_level(display_name(layer, true)), {}, -1, {}, true, {}};
  auto told = metadata.find(plain(cryptomatte.name));
  if (told == metadata.end()) told = metadata.find(plain(without_level(layer.name)));
  if (told == metadata.end()) return cryptomatte;
  cryptomatte.name = told->second.name;
  cryptomatte.header_part = told->second.part;
  cryptomatte.key = told->second.key;
  const std::string hash = value_of(file, cryptomatte, "hash"), conversion = value_of(file, cryptomatte, "conversion");
  cryptomatte.names_hash_to_ids = hash.empty() || normalised(hash) == normalised("MurmurHash3_32");
  if (!conversion.empty() && normalised(conversion) != normalised("uint32_to_float32"))
    cryptomatte.defect = "its ids are stored as \"" + printable(conversion) + "\" (uint32_to_float32 is known)";
  return cryptomatte;
}

bool looks_like_one(const Cryptomatte& cryptomatte) {
  return cryptomatte.header_part >= 0 || plain(cryptomatte.name).find("crypto") != std::string::npos;
}

int level_number(const RoleLayer& level) { return std::stoi(level.layer.substr(level.layer.size() - digits)); }

/// In the order of their numbers, each once.
void put_in_order(Cryptomatte& cryptomatte) {
  std::vector<RoleLayer>& levels = cryptomatte.levels;
  std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return level_number(a) < level_number(b); });
  levels.erase(std::unique(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return level_number(a) == level_number(b); }),
               levels.end());
  if (level_number(levels.front()) > 0 && cryptomatte.defect.empty())
    cryptomatte.defect = "layer \"" + printable(without_level(levels.front().layer)) + "00\", which has its first ranks, is missing";
}

}  // namespace

std::size_t Cryptomatte::ranks() const {
  std::size_t count = 0;
  for (const RoleLayer& level : levels) count += level.channels.size() / 2;
  return count;
}

std::vector<Cryptomatte> cryptomattes_of(const ExrFile& file, const Reading& reading) {
  const MetadataByName metadata = metadata_of(file);
  std::vector<Cryptomatte> all;
  std::map<std::string, std::size_t> known;  // by the layer's name without digits
  for (const Layer& layer : chosen_layers(layers_of(file), reading.view_layer, reading.view)) {
    RoleLayer level = level_of(layer);
    if (!ends_in_level(layer.name) || level.channels.empty()) continue;
    const auto [place, fresh] = known.try_emplace(without_level(display_name(layer, true)), all.size());
    if (fresh) all.push_back(begun(file, metadata, layer));
    Cryptomatte& cryptomatte = all[place->second];
    if (cryptomatte.defect.empty()) cryptomatte.defect = defect_of(level);
    cryptomatte.levels.push_back(std::move(level));
  }
  std::erase_if(all, [](const Cryptomatte& c) { return !looks_like_one(c); });
  for (Cryptomatte& cryptomatte : all) put_in_order(cryptomatte);
  return all;
}

bool goes_by(const Cryptomatte& cryptomatte, const std::string& name) {
  const std::string meant = plain(without_level(name)), own = plain(cryptomatte.name), layer = plain(without_level(cryptomatte.levels.front().layer));
  return meant == own || meant == layer;
}

Manifest manifest_of(const ExrFile& file, const Cryptomatte& cryptomatte) {
  if (cryptomatte.header_part < 0) return {};
  const Imf::Header& header = file.parts()[std::size_t(cryptomatte.header_part)].header;
  return read_manifest(file.path(), text_attribute(header, cryptomatte.key + "manifest"), text_attribute(header, cryptomatte.key + "manif_file"));
}

}  // namespace relume
