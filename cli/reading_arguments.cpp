// ReadingArguments: the command line's words into ReadingOptions.
#include "cli/reading_arguments.h"

#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/roles.h"
#include "host/json.h"
#include "host/rig.h"

namespace relume {

void ReadingArguments::add_to(CLI::App& command) {
  const char* group = "What the file does not say";
  command.add_option("--convention", convention, "which renderer wrote the file (relume list conventions); default: told from the file")
      ->group(group);
  command
      .add_option("--map", map,
                  "ROLE=LAYER: the layer that holds a role (relume list roles): normal, position, ids, ..., or a parameter (albedo, roughness, ...)")
      ->group(group);
  command.add_option("--part", part, "the part of a multi-part file")->group(group);
  command.add_option("--view-layer", view_layer, "Blender's view layer; default: the first")->group(group);
  command.add_option("--view", view, "the stereo view: left, right; default: the first")->group(group);
  command.add_option("--camera", camera, "a rig, a glTF or an EXR that has the camera, or auto: recovered from the positions")->group(group);
  command.add_option("--normal-space", normal_space, "space of the normals")->check(CLI::IsMember({"world", "camera", "view-ray"}))->group(group);
  command.add_option("--position-space", position_space, "space of the positions")->check(CLI::IsMember({"world", "camera"}))->group(group);
  command.add_option("--normal-encoding", normal_encoding, "-1..1 or 0..1")->check(CLI::IsMember({"signed", "unsigned"}))->group(group);
  command.add_option("--normal-axes", normal_axes, "how stored components make up x,y,z: x,-y,z is a flipped green")->group(group);
  command.add_option("--position-axes", position_axes, "the same for positions: x,z,-y takes y up to z up")->group(group);
  command.add_option("--position-scale", position_scale, "world units for one of the stored positions': 0.01 where they are in centimetres")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_option("--depth-kind", depth_kind, "along the camera's axis, or along each pixel's ray")
      ->check(CLI::IsMember({"z", "distance"}))
      ->group(group);
  command.add_option("--premultiplied", premultiplied, "whether layers are means over the pixel that count misses as 0")
      ->check(CLI::IsMember({"yes", "no"}))
      ->group(group);
  command
      .add_option("--facing", facing, "normals that point away from the viewer: as-stored (lit where n.l > 0), one-sided (black), two-sided (turned)")
      ->check(CLI::IsMember({"as-stored", "one-sided", "two-sided"}))
      ->group(group);
  command.add_option("--bump-shadowing", bump_shadowing, "light against the unperturbed normal: none, horizon, smith (Mitsuba's default)")
      ->check(CLI::IsMember({"none", "horizon", "smith"}))
      ->group(group);
}

namespace {

/// A mistyped role would be mapped and never read.
void check_role(const std::string& role) {
  if (find_role(role)) return;
  std::vector<std::string_view> names;
  for (const Role& known : roles()) names.push_back(known.name);
  throw Error(ErrorKind::input, "--map: no role " + in_quotes(role) + " (has: " + listed(names) + ")");
}

/// "x,-y,z": each axis once, with or without a minus.
Axes axes_of(const char* option, const std::string& text) {
  Axes axes;
  std::array<bool, 3> used{};
  std::stringstream words(text);
  std::size_t i = 0;
  for (std::string word; std::getline(words, word, ','); ++i) {
    const bool negative = word.starts_with('-');
    const std::size_t axis = word.size() == std::size_t(negative ? 2 : 1) ? std::string_view("xyz").find(word.back()) : std::string_view::npos;
    if (i >= 3 || axis == std::string_view::npos || std::exchange(used[axis], true)) break;
    axes.from[i] = int(axis);
    axes.sign[i] = negative ? -1 : 1;
  }
  if (i != 3 || text.ends_with(',')) throw Error(ErrorKind::input, std::string(option) + " " + text + ": is not three axes, each once (x,-y,z)");
  return axes;
}

}  // namespace

ReadingOptions ReadingArguments::options() const {
  ReadingOptions options;
  options.convention = convention;
  if (part >= 0) options.part = part;
  options.view_layer = view_layer;
  options.view = view;
  for (const std::string& entry : map) {
    const std::size_t equals = entry.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == entry.size())
      throw Error(ErrorKind::input, "--map " + entry + ": is not ROLE=LAYER (--map normal=N)");
    check_role(entry.substr(0, equals));
    options.map[entry.substr(0, equals)] = entry.substr(equals + 1);
  }
  if (!normal_space.empty())
    options.normal_space = normal_space == "world" ? Space::world : normal_space == "camera" ? Space::camera : Space::view_ray;
  if (!position_space.empty()) options.position_space = position_space == "world" ? Space::world : Space::camera;
  if (!normal_encoding.empty()) options.normal_encoding = normal_encoding == "signed" ? NormalEncoding::as_signed : NormalEncoding::as_unsigned;
  if (!normal_axes.empty()) options.normal_axes = axes_of("--normal-axes", normal_axes);
  if (!position_axes.empty()) options.position_axes = axes_of("--position-axes", position_axes);
  if (position_scale > 0) options.position_scale = position_scale;
  if (!depth_kind.empty()) options.depth_kind = depth_kind == "z" ? DepthKind::z : DepthKind::distance;
  if (!premultiplied.empty()) options.premultiplied = premultiplied == "yes";
  if (!facing.empty()) options.facing = facing == "as-stored" ? Facing::as_stored : facing == "one-sided" ? Facing::one_sided : Facing::two_sided;
  if (!bump_shadowing.empty())
    options.bump_shadowing = bump_shadowing == "none"      ? BumpShadowing::none
                             : bump_shadowing == "horizon" ? BumpShadowing::horizon
                                                           : BumpShadowing::smith;
  options.recover_camera = camera == "auto";
  if (!camera.empty() && camera != "auto") options.camera = camera_from(camera);
  return options;
}

Camera camera_from(const std::string& file) {
  if (std::filesystem::path(file).extension() == ".exr") {
    const Reading reading = understand(ExrFile(file), {});
    if (reading.camera) return *reading.camera;
  } else if (const Rig rig = read_rig(file, {}); rig.camera) {
    return *rig.camera;
  }
  throw Error(ErrorKind::input,
              file + ": no camera in it (a rig with \"camera\", a glTF with a camera node, or an EXR with camera attributes has one)");
}

}  // namespace relume
