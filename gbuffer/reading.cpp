// Understanding a file: convention, view layer and view, roles, what the user says, then what the data tell.
#include "gbuffer/reading.h"

#include <algorithm>
#include <functional>
#include <set>

#include "gbuffer/convention.h"
#include "gbuffer/cryptomatte.h"
#include "gbuffer/error.h"
#include "gbuffer/filtered_layers.h"
#include "gbuffer/find_camera.h"
#include "gbuffer/printable.h"
#include "gbuffer/role_layers.h"
#include "gbuffer/samples.h"
#include "gbuffer/solver/solve.h"

namespace relume {

namespace {

[[noreturn]] void refuse(const ExrFile& file, const std::string& what) { throw Error(ErrorKind::input, file.path().string() + ": " + what); }

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t enough = 40;  // a line is read by a person
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), enough); ++i) text += (i ? ", " : "") + printable(names[i]);
  return names.size() > enough ? text + ", and " + std::to_string(names.size() - enough) + " more" : text;
}

std::vector<std::string> distinct(const std::vector<Layer>& layers, const std::function<std::string(const Layer&)>& name) {
  std::vector<std::string> names;
  for (const Layer& layer : layers)
    if (const std::string n = name(layer); !n.empty() && std::find(names.begin(), names.end(), n) == names.end()) names.push_back(n);
  return names;
}

std::string require(const ExrFile& file, const std::string& what, const std::string& asked, const std::vector<std::string>& there) {
  if (std::find(there.begin(), there.end(), asked) != there.end()) return asked;
  refuse(file, "no " + what + " \"" + printable(asked) + '"' + (there.empty() ? " (the file has none)" : " (there are: " + joined(there) + ")"));
}

/// The one asked for, else the first that holds normals: a compositor's result without them may stand before the render.
std::string choose_view_layer(const ExrFile& file, const std::vector<Layer>& layers, const ReadingOptions& options, Reading& reading) {
  const auto names = distinct(layers, [](const Layer& l) { return l.view_layer; });
  if (!options.view_layer.empty()) return require(file, "view layer", options.view_layer, names);
  if (names.empty()) return {};
  const auto full = distinct(layers, [](const Layer& l) { return normalised(l.name) == "normal" ? l.view_layer : std::string(); });
  const std::string choice = full.empty() ? names.front() : full.front();
  std::vector<std::string> others;
  for (const std::string& name : names)
    if (name != choice) others.push_back(name);
  if (!others.empty())
    reading.notes.push_back("view layer \"" + printable(choice) + "\" is read; there are also: " + joined(others) + " (--view-layer NAME chooses)");
  return choice;
}

/// The one asked for, else the file's default view.
std::string choose_view(const ExrFile& file, const std::vector<Layer>& layers, const ReadingOptions& options, Reading& reading) {
  std::vector<std::string> names = file.views();
  if (names.empty()) names = distinct(layers, [](const Layer& l) { return l.view; });
  if (!options.view.empty()) return require(file, "view", options.view, names);
  if (names.empty()) return {};
  if (names.size() > 1)
    reading.notes.push_back("view \"" + printable(names.front()) + "\" is read; there are also: " + joined({names.begin() + 1, names.end()}) +
                            " (--view NAME chooses)");
  return names.front();
}

void apply_options(const ReadingOptions& options, Reading& reading) {
  if (options.normal_space) reading.normal_space = *options.normal_space;
  if (options.position_space) reading.position_space = *options.position_space;
  if (options.normal_encoding) reading.normal_encoding = *options.normal_encoding;
  if (options.normal_axes) reading.normal_axes = *options.normal_axes;
  if (options.position_axes) reading.position_axes = *options.position_axes;
  if (options.position_scale) reading.position_scale = *options.position_scale;
  if (options.depth_kind) reading.depth_kind = *options.depth_kind;
  if (options.facing) reading.facing = *options.facing;
  if (options.bump_shadowing) reading.bump_shadowing = *options.bump_shadowing;
}

/// Positions can be made from depth, and normals from either.
void require_roles(const ExrFile& file, const ReadingOptions& options, const Reading& reading) {
  if (reading.roles.contains("position") || reading.roles.contains("depth")) return;
  const std::string role = reading.roles.contains("normal") ? "position" : "normal";
  const auto tried = reading.looked_for.find(role);
  const std::string names = tried == reading.looked_for.end() ? "" : "looked for " + tried->second + "; ";
  refuse(file, "part " + std::to_string(options.part.value_or(0)) + ": no " + role + (role == "position" ? " or depth" : "") + " layer (" + names +
                   "--map " + role + "=LAYER names one)");
}

/// What the file lacks is made from what it has, and said.
void make_missing(const ExrFile& file, Reading& reading) {
  const std::string camera = reading.camera ? " and the camera (" + reading.camera->source + ")" : "";
  if (is_made(reading, "position")) {
    if (!reading.camera || !reading.camera->lens)
      refuse(file, "part " + std::to_string(reading.part) + ": no position layer, and none can be made from depth without a camera's field of view" +
                       " (--map position=LAYER names a layer, --camera FILE a camera)");
    const std::string kind = reading.depth_kind == DepthKind::z ? ", along the axis" : ", along the ray";
    reading.made.push_back("position from depth (" + reading.roles.at("depth").layer + kind + ")" + camera);
  }
  if (is_made(reading, "normal"))
    reading.made.push_back(std::string("normal from ") + (is_made(reading, "position") ? "the positions made" : reading.roles.at("position").layer) +
                           ": facets, without bump or smoothing (--map normal=LAYER names a layer)");
  if (is_made(reading, "albedo"))
    reading.made.push_back("albedo from " + reading.roles.at("diffuse_light").layer + " over " + reading.roles.at("diffuse_raw_light").layer +
                           ", black where no light fell (--map albedo=LAYER names a layer)");
}

/// What the data left open is worth a word wherever the file is used: if it is the other, the whole picture is wrong.
void note_unsure(Reading& reading) {
  for (const Verdict& v : reading.verdicts)
    if (!v.sure)
      reading.notes.push_back("warning: " + v.question + " is taken to be " + v.answer + ", but that is not sure: " + v.evidence + " (" + v.option +
                              (v.option.find(',') == std::string::npos ? " overrules)" : " overrule)"));
}

/// Output follows the part with the positions; pixels that some layer lacks are left out.
void set_windows(const ExrFile& file, Reading& reading) {
  reading.part = reading.roles.at(is_made(reading, "position") ? "depth" : "position").part;
  const Part& part = file.parts()[std::size_t(reading.part)];
  reading.display_window = part.display_window;
  reading.pixel_aspect = part.header.pixelAspectRatio();
  Window& window = reading.data_window = part.data_window;
  for (const auto& [role, layer] : reading.roles) window = intersection(window, file.parts()[std::size_t(layer.part)].data_window);
  if (window.empty()) refuse(file, "part " + std::to_string(reading.part) + ": the layers' data windows have no pixel in common");
}

/// A name as people write it, against what the file has: the narrowest kind of likeness that finds one wins.
std::optional<RoleLayer> like(const std::vector<Layer>& layers, const std::string& name, const std::string& role) {
  const auto exact = [](const std::string& text) { return text; };
  const auto unspaced = [](const std::string& text) { return normalised(text); };
  for (const std::function<std::string(const std::string&)>& form : {std::function<std::string(const std::string&)>(exact), {unspaced}}) {
    for (const bool with_view_layer : {false, true})
      for (const Layer& layer : layers)
        if (form(display_name(layer, with_view_layer)) == form(name))
          if (RoleLayer found = as_role(layer, role); !found.channels.empty()) return found;
    for (const Layer& layer : layers)
      for (const Component& component : layer.components)
        if (form(component.channel) == form(name)) return RoleLayer{layer.part, component.channel, {component.channel}, {component.type}};
  }
  return {};
}

RoleLayer found_layer(const ExrFile& file, const std::vector<Layer>& layers, const std::string& name, const std::string& role) {
  const bool direction = role == "normal" || role == "position" || role == "base_normal" || role == "tangent";
  const auto found = like(layers, name, role);
  if (found && (!direction || found->channels.size() == 3)) return *found;
  std::vector<std::string> names;
  for (const Layer& layer : layers)
    if (!direction || !layer.triple().empty()) names.push_back(display_name(layer, false));
  refuse(file, "no layer \"" + printable(name) + '"' + (role.empty() ? "" : " for " + printable(role)) + (direction ? " with three components" : "") +
                   " (there are: " + joined(names) + ")");
}

bool names_cryptomatte(const ExrFile& file, const Reading& reading, const std::string& name) {
  const std::vector<Cryptomatte> all = cryptomattes_of(file, reading);
  return std::any_of(all.begin(), all.end(), [&](const Cryptomatte& c) { return goes_by(c, name); });
}

void apply_map(const ExrFile& file, const ReadingOptions& options, Reading& reading, const std::vector<Layer>& layers) {
  for (const auto& [role, name] : options.map) {
    if (role == "ids" && names_cryptomatte(file, reading, name))
      reading.ids_cryptomatte = name;
    else
      reading.roles[role] = found_layer(file, layers, name, role);
  }
}

}  // namespace

const char* name_of(Space space) { return space == Space::world ? "world" : space == Space::camera ? "camera" : "view ray"; }

const Convention& convention_of(const ExrFile& file, const ReadingOptions& options) {
  const auto& all = conventions();
  const auto layers = layers_of(file);
  if (options.convention.empty()) {
    const auto weight = [&](const Convention& convention) { return evidence_for(convention, file, layers).weight; };
    return *std::max_element(all.begin(), all.end(), [&](const Convention& a, const Convention& b) { return weight(a) < weight(b); });
  }
  std::vector<std::string> names;
  for (const Convention& convention : all) {
    if (convention.name == options.convention) return convention;
    names.push_back(convention.name);
  }
  refuse(file, "no convention \"" + printable(options.convention) + "\" (there are: " + joined(names) + ")");
}

bool is_made(const Reading& reading, const std::string& role) {
  if (reading.roles.contains(role)) return false;
  if (role == "albedo") return reading.roles.contains("diffuse_light") && reading.roles.contains("diffuse_raw_light");
  return role == "position" || role == "normal";
}

RoleLayer find_layer(const ExrFile& file, const Reading& reading, const std::string& name) {
  return found_layer(file, chosen_layers(layers_of(file), reading.view_layer, reading.view), name, "");
}

Reading understand(const ExrFile& file, const ReadingOptions& options) {
  if (options.part && (*options.part < 0 || *options.part >= int(file.parts().size())))
    refuse(file, "no part " + std::to_string(*options.part) + " (there are " + std::to_string(file.parts().size()) + ", counted from 0)");
  const Convention& convention = convention_of(file, options);
  auto layers = layers_of(file);
  if (options.part) std::erase_if(layers, [&](const Layer& layer) { return layer.part != *options.part; });
  Reading reading;
  reading.convention = convention.name;
  reading.evidence = options.convention.empty() ? evidence_for(convention, file, layers_of(file)).words : "asked for";
  reading.view_layer = choose_view_layer(file, layers, options, reading);
  reading.view = choose_view(file, layers, options, reading);
  const auto chosen = chosen_layers(layers, reading.view_layer, reading.view);
  assign_roles(convention, file, chosen, reading);
  apply_map(file, options, reading, chosen);
  apply_options(options, reading);
  require_roles(file, options, reading);
  set_windows(file, reading);
  Samples samples(file);
  if (convention.settle_space) convention.settle_space(samples, options, reading);
  solve_before_camera(samples, options, reading);
  find_camera(samples, options, reading);
  solve_with_camera(samples, options, reading);
  note_unsure(reading);
  make_missing(file, reading);
  if (convention.settle) convention.settle(samples, options, reading);
  reading.filtered = looks_filtered(samples, reading);
  return reading;
}

}  // namespace relume
