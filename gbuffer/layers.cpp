// Channel names taken apart: view layer, layer, view and component.
#include "gbuffer/layers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

namespace relume {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

namespace {

/// The short letter of a component, long names and either case alike; empty if the word is none.
std::optional<char> letter_of(const std::string& word) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> words{{{"red", 'r'}, {"green", 'g'}, {"blue", 'b'}, {"alpha", 'a'}, {"id", 'i'}}};
  const std::string known = lower(word);
  for (const auto& [name, letter] : words)
    if (known == name) return letter;
  if (known.size() == 1 && std::string_view("rgbaxyzuvwti").find(known[0]) != std::string_view::npos) return known[0];
  return {};
}

bool ends_with_token(const std::string& name, const std::string& token) {
  return name == token || (name.size() > token.size() && name.ends_with(token) && name[name.size() - token.size() - 1] == '.');
}

/// What all channels of a file tell about how to read one.
struct Names {
  std::vector<std::string> views;
  bool blender = false, many_parts = false;
  bool root_vector = false;              ///< this part has channels X, Y and Z
  std::vector<std::string> view_layers;  ///< Blender's, longest first, so that "ViewLayer.001" wins over "ViewLayer"
};

/// The layer of a full channel name and its component; a component that is no known letter stays part of the layer's name.
struct Split {
  std::string layer;
  char letter = 0;
};

Split split(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  if (dot == std::string::npos) return {channel, 0};
  const std::string layer = channel.substr(0, dot), word = channel.substr(dot + 1);
  if (const auto letter = letter_of(word)) return {layer, *letter};
  if (ends_with_token(layer, word)) return {layer, 0};  // Karma's scalars repeat the name: "hitdist.hitdist"
  return {channel, 0};
}

std::string without_view(std::string layer, const std::vector<std::string>& views, std::string& view) {
  for (const std::string& candidate : views) {
    if (!ends_with_token(layer, candidate)) continue;
    view = candidate;
    layer.resize(layer.size() - candidate.size());
    if (layer.ends_with('.')) layer.pop_back();
    return layer;
  }
  return layer;
}

/// Blender view layers may hold dots ("ViewLayer.001"): every name before ".Combined", ".Normal" and the like is one.
std::vector<std::string> blender_view_layers(const ExrFile& file) {
  std::set<std::string> found;
  for (const Part& part : file.parts()) {
    for (const Channel& channel : part.channels) {
      std::string view;
      const std::string layer = without_view(split(channel.name).layer, file.views(), view);
      for (const char* pass : {".Combined", ".Depth", ".Normal", ".Position", ".DiffCol", ".Diffuse Color"})
        if (layer.ends_with(pass)) found.insert(layer.substr(0, layer.size() - std::string_view(pass).size()));
    }
  }
  std::vector<std::string> names(found.begin(), found.end());
  std::stable_sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return names;
}

bool beauty_name(const std::string& part) {
  static const std::set<std::string> names{"", "rgba", "rgb", "beauty", "c", "ci", "combined", "main", "image", "part0"};
  return names.contains(normalised(part));
}

bool root_letter(char letter) { return letter == 'r' || letter == 'g' || letter == 'b' || letter == 'a'; }

/// A bare channel that is one of three, "Nsx" beside "Nsy" and "Nsz" (old pbrt), "NX" (3ds Max), "normal_r"; or one of "u" and "v".
std::optional<Split> one_of_several(const Part& part, const std::string& channel) {
  if ((channel == "u" && part.has_channel("v")) || (channel == "v" && part.has_channel("u"))) return Split{"uv", channel[0]};
  std::string stem = channel.substr(0, channel.size() - 1);
  for (const std::string_view letters : {"xyz", "XYZ", "rgb", "RGB"}) {
    if (stem.empty() || letters.find(channel.back()) == std::string_view::npos) continue;
    if (!std::all_of(letters.begin(), letters.end(), [&](char letter) { return part.has_channel(stem + letter); })) continue;
    while (!stem.empty() && (stem.back() == '_' || stem.back() == ' ' || stem.back() == '-')) stem.pop_back();
    return Split{stem, char(std::tolower(channel.back()))};
  }
  return {};
}

/// A channel without a dot. In a named part of a multi-part file the part is the layer (Arnold); else R G B A are the root layer, and X Y Z
/// if all three are there; any other name is a layer of its own ("Z", "dzdx"), unless it is one of several.
Split bare(const Part& part, const std::string& channel, const Names& names) {
  const auto letter = letter_of(channel);
  const bool part_is_layer = names.many_parts && !part.name.empty() && (part.index > 0 || !beauty_name(part.name));
  if (part_is_layer && letter) return {part.name, normalised(part.name) == normalised(channel) ? char(0) : *letter};
  if (part_is_layer && normalised(part.name) == normalised(channel)) return {part.name, 0};
  if (const auto several = one_of_several(part, channel)) return *several;
  if (letter && (root_letter(*letter) || (names.root_vector && *letter >= 'x' && *letter <= 'z'))) return {"", *letter};
  return {channel, 0};
}

Layer taken_apart(const Part& part, const Channel& channel, const Names& names) {
  const bool dotted = channel.name.find('.') != std::string::npos;
  const Split parts = dotted ? split(channel.name) : bare(part, channel.name, names);
  Layer layer;
  layer.part = part.index;
  layer.view = part.view;
  layer.name = without_view(parts.layer, names.views, layer.view);
  if (names.blender) {
    const auto before = [&](const std::string& v) {
      return layer.name.size() > v.size() && layer.name.starts_with(v) && layer.name[v.size()] == '.';
    };
    const auto known = std::find_if(names.view_layers.begin(), names.view_layers.end(), before);
    const std::size_t dot = known != names.view_layers.end() ? known->size() : layer.name.find('.');
    if (dot != std::string::npos) {
      layer.view_layer = layer.name.substr(0, dot);
      layer.name = layer.name.substr(dot + 1);
    }
  }
  layer.components.push_back({parts.letter, channel.name, channel.type});
  return layer;
}

}  // namespace

const Component* Layer::component(char letter) const {
  const auto found = std::find_if(components.begin(), components.end(), [&](const Component& c) { return c.letter == letter; });
  return found == components.end() ? nullptr : &*found;
}

std::vector<std::string> Layer::triple() const {
  for (const char* letters : {"xyz", "rgb", "uvw"}) {
    const Component *const a = component(letters[0]), *const b = component(letters[1]), *const c = component(letters[2]);
    if (a && b && c) return {a->channel, b->channel, c->channel};
  }
  return {};
}

std::vector<Layer> layers_of(const ExrFile& file) {
  Names names{file.views(), !blender_marks(file).empty(), file.parts().size() > 1, false, {}};
  if (names.blender) names.view_layers = blender_view_layers(file);
  std::vector<Layer> layers;
  for (const Part& part : file.parts()) {
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> known;
    names.root_vector = part.has_channel("X") && part.has_channel("Y") && part.has_channel("Z");
    for (const Channel& channel : part.channels) {
      Layer layer = taken_apart(part, channel, names);
      const auto [place, fresh] = known.try_emplace({layer.view_layer, layer.name, layer.view}, layers.size());
      if (fresh)
        layers.push_back(std::move(layer));
      else
        layers[place->second].components.push_back(layer.components.front());
    }
  }
  return layers;
}

std::string blender_marks(const ExrFile& file) {
  const Imf::Header& header = file.parts().front().header;
  if (text_attribute(header, "BlenderMultiChannel")) return "header attribute BlenderMultiChannel";
  if (const auto software = text_attribute(header, "Software"); software && lower(*software).find("blender") != std::string::npos)
    return "header attribute Software = \"" + *software + '"';
  // Stereo files of Blender 4 carry neither attribute, but the layers are as telling.
  for (const Part& part : file.parts()) {
    for (const Channel& channel : part.channels) {
      std::string view;
      const std::string layer = without_view(split(channel.name).layer, file.views(), view);
      for (const char* pass : {".Combined", ".DiffCol", ".Diffuse Color", ".GlossCol", ".Glossy Color"})
        if (layer.ends_with(pass)) return "channel \"" + channel.name + '"';
    }
  }
  return {};
}

std::string normalised(const std::string& layer_name) {
  std::string plain = lower(layer_name);
  std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-'; });
  return plain;
}

}  // namespace relume
