// Conventions compared with a file, and applied to its layers.
#include "gbuffer/convention.h"

#include <algorithm>

#include "gbuffer/common_names.h"
#include "gbuffer/conventions/list.h"
#include "gbuffer/printable.h"
#include "gbuffer/role_layers.h"

namespace relume {

#define RELUME_DECLARE(name) extern const Convention convention_##name;
RELUME_CONVENTIONS(RELUME_DECLARE)

const std::vector<Convention>& conventions() {
#define RELUME_ENTRY(name) convention_##name,
  static const std::vector<Convention> list{RELUME_CONVENTIONS(RELUME_ENTRY)};
  return list;
}

namespace {

/// What speaks more is taken: a renderer's attribute is its own, names of layers others may use too, a tool only passes a file on.
enum Weight { nothing, anyone, tool, names, header };

/// Nuke keeps the attributes of what it read, some versions under a prefix of their own.
std::string without_nuke(std::string attribute) {
  for (const char* prefix : {"nuke/", "exr/"})
    if (attribute.starts_with(prefix) && attribute.find('/', std::string_view(prefix).size()) != std::string::npos)
      attribute.erase(0, std::string_view(prefix).size());
  return attribute;
}

bool fits(const std::string& pattern, const std::string& name) {
  return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

/// The attribute that the mark speaks of, as a person would quote it; empty if no part has it.
std::string attribute_found(const Mark& mark, const ExrFile& file) {
  for (const Part& part : file.parts())
    for (const std::string& attribute : attribute_names(part.header)) {
      if (!fits(lower(mark.attribute), lower(attribute)) && !fits(lower(mark.attribute), without_nuke(lower(attribute)))) continue;
      if (!mark.text) return printable(attribute);
      const auto text = text_attribute(part.header, attribute);
      if (text && lower(*text).find(lower(mark.text)) != std::string::npos) return printable(attribute) + " = \"" + printable(*text) + '"';
    }
  return {};
}

/// The layers that the mark speaks of, comma between; empty if one is missing.
std::string layers_found(const Mark& mark, const std::vector<Layer>& layers) {
  std::string found;
  for (const char* name : mark.layers) {
    const std::string pattern = normalised(name);
    const auto layer = std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return fits(pattern, normalised(l.name)); });
    if (layer == layers.end()) return {};
    found += (found.empty() ? "" : ", ") + printable(layer->name);
  }
  return found;
}

Evidence evidence_of(const Mark& mark, const Convention& convention, const ExrFile& file, const std::vector<Layer>& layers) {
  const std::string attribute = mark.attribute ? attribute_found(mark, file) : "", named = layers_found(mark, layers);
  if ((mark.attribute && attribute.empty()) || (!mark.layers.empty() && named.empty())) return {};
  if (convention.writes_again) return {tool, "header attribute " + attribute + ", which says who wrote it last, and no renderer's marks"};
  if (mark.attribute) return {header, "header attribute " + attribute + (named.empty() ? "" : " and layers " + named)};
  return {names, "layers " + named + ": likely, not certain"};
}

}  // namespace

Evidence evidence_for(const Convention& convention, const ExrFile& file, const std::vector<Layer>& layers) {
  if (convention.marks.empty() && !convention.recognise) return {anyone, "no renderer's marks: common names"};
  Evidence best;
  for (const Mark& mark : convention.marks)
    if (Evidence evidence = evidence_of(mark, convention, file, layers); evidence.weight > best.weight) best = std::move(evidence);
  if (best.weight > nothing || !convention.recognise) return best;
  if (std::string words = convention.recognise(file, layers); !words.empty()) return {words.starts_with("header") ? header : names, std::move(words)};
  return {};
}

void choose_common_lobes(Reading& reading) {
  for (const char* role : {"roughness", "glossiness", "exponent", "alpha"})
    if (reading.roles.contains(role)) {
      reading.default_diffuse = "gltf";
      reading.default_specular = "ggx";
      return;
    }
  reading.default_diffuse = "lambert";
  reading.default_specular = "none";
  reading.notes.push_back("no roughness layer: only diffuse light is shaded (--map roughness=LAYER, or --specular NAME with --set, say otherwise)");
}

namespace {

/// DWA takes a channel named Y for luminance, and R G B for colour, and quantises them by what an eye would miss: X and Z of a position stay exact.
void note_lossy_layers(const ExrFile& file, Reading& reading) {
  for (const char* role : {"position", "normal"}) {
    const auto layer = reading.roles.find(role);
    if (layer == reading.roles.end()) continue;
    const Imf::Compression codec = file.parts()[std::size_t(layer->second.part)].header.compression();
    const bool seen = std::any_of(layer->second.channels.begin(), layer->second.channels.end(), [](const std::string& channel) {
      return std::string_view("RGBY").find(channel.back()) != std::string_view::npos && (channel.size() == 1 || channel[channel.size() - 2] == '.');
    });
    if (!seen || (codec != Imf::DWAA_COMPRESSION && codec != Imf::DWAB_COMPRESSION)) continue;
    reading.notes.push_back(
        "warning: DWA compression keeps channels named Y only roughly, and R G B too, so positions and normals are off (ZIP keeps them)");
    return;
  }
}

/// The quotient of lit and unlit diffuse light is the albedo, which is of use only where there is none, and takes both.
void keep_light_for_albedo(Reading& reading) {
  const bool needed = !reading.roles.contains("albedo") && !reading.roles.contains("base_color");
  if (needed && reading.roles.contains("diffuse_light") && reading.roles.contains("diffuse_raw_light")) return;
  reading.roles.erase("diffuse_light");
  reading.roles.erase("diffuse_raw_light");
}

}  // namespace

void assign_roles(const Convention& convention, const ExrFile& file, const std::vector<Layer>& layers, Reading& reading) {
  const std::vector<NamedLayer> named =
      named_layers(layers, [&](const Layer& layer) { return convention.known_as ? convention.known_as(file, layer) : layer.name; });
  reading.facing = convention.facing;
  reading.colour_premultiplied = convention.colour_premultiplied;
  for (const Alias& alias : convention.aliases) assign(reading, named, alias);
  if (convention.takes_common_names) assign_common_names(reading, named);
  if (convention.assign) convention.assign(file, layers, reading);
  keep_light_for_albedo(reading);
  note_lossy_layers(file, reading);
  (convention.choose_lobes ? convention.choose_lobes : choose_common_lobes)(reading);
}

std::string marks_in_words(const Convention& convention) {
  std::string words;
  for (const Mark& mark : convention.marks) {
    std::string one = mark.attribute ? std::string("header ") + mark.attribute : "";
    if (mark.text) one += std::string(" that contains \"") + mark.text + '"';
    for (const char* layer : mark.layers)
      one += (layer == mark.layers.front() ? (one.empty() ? "layer " : " with layer ") : " and ") + std::string(layer);
    words += (words.empty() ? "" : "; ") + one;
  }
  return words;
}

}  // namespace relume
