// BakeArguments: text to cameras; a picture's size follows from the camera's own, where an EXR tells one.
#include "cli/bake_arguments.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "bake/framing.h"
#include "gbuffer/error.h"
#include "gbuffer/layers.h"
#include "gbuffer/printable.h"
#include "gbuffer/reading.h"
#include "host/rig.h"

namespace relume {
namespace {

constexpr double usual_fov = 40;  // degrees, of height: a portrait's to a normal lens

glm::dvec3 point_of(const char* option, const std::string& text) {
  glm::dvec3 p(0);
  char end = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &p.x, &p.y, &p.z, &end) != 3 || !std::isfinite(p.x + p.y + p.z))
    throw Error(ErrorKind::input, std::string(option) + " " + printable(text) + ": is not X,Y,Z");
  return p;
}

struct Size {
  int width, height;
};

std::optional<Size> size_of(const std::string& text) {
  if (text.empty()) return {};
  Size size{};
  char end = 0;
  if (std::sscanf(text.c_str(), "%7dx%7d%c", &size.width, &size.height, &end) != 2 || size.width < 1 || size.height < 1)
    throw Error(ErrorKind::input, "--size " + printable(text) + ": is not WxH (1920x1080)");
  return size;
}

/// The same view in a picture of another size: what is seen from top to bottom stays.
void resize(Camera& camera, const Window& from, const Size& to) {
  if (!camera.lens) return;
  Lens& lens = *camera.lens;
  const double scale = double(to.height) / from.height();
  lens = {lens.scale_x * scale, lens.scale_y * scale, 0.5 * to.width + scale * (lens.centre_x - 0.5 * (from.min_x + from.max_x)),
          0.5 * to.height + scale * (lens.centre_y - 0.5 * (from.min_y + from.max_y))};
}

MeshOptions::Up up_of(const std::string& text) {
  return text.empty() ? MeshOptions::Up::as_stored : text == "z" ? MeshOptions::Up::z : MeshOptions::Up::y;
}

}  // namespace

void BakeArguments::add_to(CLI::App& command) {
  const char *view = "Camera", *mesh = "Mesh";
  const auto from =
      command.add_option("--camera", camera, "of a rig, a glTF or another EXR; default: the mesh file's own, else one that frames the mesh")
          ->group(view);
  const auto placed = command.add_option("--eye", eye, "X,Y,Z: where a camera is placed instead")->excludes(from)->group(view);
  command.add_option("--target", target, "X,Y,Z: what it looks at; default: the mesh's middle")->needs(placed)->group(view);
  command.add_option("--fov", fov, "its field of view, degrees from top to bottom (default 40)")->check(CLI::Range(0.01, 179.0))->group(view);
  command.add_option("--orthographic", height, "it sees parallel rays, so many units from top to bottom")->check(CLI::PositiveNumber)->group(view);
  command
      .add_option(
          "--size", size,
          "WxH pixels; default: the camera's own where an EXR tells it, else " + std::to_string(usual_width) + "x" + std::to_string(usual_height))
      ->group(view);
  command.add_option("--normals", normals, "the file's (default; smooth where it has none), or made: smooth or flat")
      ->check(CLI::IsMember({"stored", "smooth", "flat"}))
      ->group(mesh);
  command.add_option("--mesh-up", mesh_up, "the axis that points up in an OBJ, PLY or STL (default y; glTF's is y)")
      ->check(CLI::IsMember({"y", "z"}))
      ->group(mesh);
  command
      .add_option("--world-up", world_up, "the axis that points up in the world of camera and lights: the mesh is turned to it (default: as it is)")
      ->check(CLI::IsMember({"y", "z"}))
      ->group(mesh);
}

void BakeArguments::check() const {
  size_of(size);
  if (!eye.empty()) point_of("--eye", eye);
  if (!target.empty()) point_of("--target", target);
  if (fov > 0 && height > 0) throw Error(ErrorKind::input, "--fov and --orthographic: parallel rays have no field of view");
}

MeshOptions BakeArguments::mesh_options() const {
  MeshOptions options;
  if (normals == "smooth") options.normals = MeshOptions::Normals::smooth;
  if (normals == "flat") options.normals = MeshOptions::Normals::flat;
  options.mesh_up = up_of(mesh_up);
  options.world_up = up_of(world_up);
  return options;
}

glm::dvec3 BakeArguments::up() const {
  const std::string& told = world_up.empty() ? mesh_up : world_up;
  return told == "z" ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

Camera BakeArguments::placed_camera(const Mesh& mesh) const {
  Camera placed;
  const glm::dvec3 middle = target.empty() ? bounds_of(mesh).centre() : point_of("--target", target);
  placed.world_from_camera = looking_at(point_of("--eye", eye), middle, up());
  placed.source = "--eye";
  placed.vertical_fov = fov > 0 ? fov : usual_fov;
  return placed;
}

/// A glTF's camera is turned with its world, as the mesh is; others stand in the world already.
MeshView BakeArguments::camera_from_file(const std::string& file) const {
  const std::string place = printable(file);
  if (lower(std::filesystem::path(file).extension().string()) == ".exr") {
    const Reading reading = understand(ExrFile(file), {});
    if (!reading.camera) throw Error(ErrorKind::input, place + ": no camera in its header, and none that its positions tell");
    MeshView view{*reading.camera, reading.display_window.width(), reading.display_window.height()};
    const auto wanted = size_of(size);
    view.camera.lens = lens_of(view.camera, reading.display_window, reading.pixel_aspect);
    resize(view.camera, reading.display_window, wanted.value_or(Size{view.width, view.height}));
    return view;
  }
  RigOptions options;
  options.world_is_z_up = world_up == "z";
  options.up = RigOptions::Up::y;
  const Rig rig = read_rig(file, options);
  if (!rig.camera) throw Error(ErrorKind::input, place + ": no camera in it (a rig with \"camera\", a glTF with a camera node, or an EXR has one)");
  return {*rig.camera, 0, 0};
}

MeshView BakeArguments::view_of(const Mesh& mesh, const std::string& mesh_file, std::vector<std::string>& notes) const {
  MeshView view;
  const bool own = mesh.has_camera && camera.empty() && eye.empty();
  if (!camera.empty() || own) {
    view = camera_from_file(own ? mesh_file : camera);
    if (own) notes.push_back("the camera is the mesh file's own (--camera or --eye choose another)");
  }
  const auto wanted = size_of(size);
  if (wanted || view.width == 0) {
    view.width = wanted ? wanted->width : usual_width;
    view.height = wanted ? wanted->height : usual_height;
  }
  if (!eye.empty()) view.camera = placed_camera(mesh);
  if (camera.empty() && !own && eye.empty()) {
    view.camera = framing(mesh, up(), fov > 0 ? fov : usual_fov, double(view.width) / view.height);
    notes.push_back("no camera was given: one that frames the mesh is taken (--camera, or --eye with --target and --fov, say otherwise)");
  }
  if (height > 0) {
    view.camera.projection = Camera::Projection::orthographic;
    view.camera.height = height;
    view.camera.lens.reset();
  } else if (fov > 0 && view.camera.projection == Camera::Projection::perspective) {
    view.camera.vertical_fov = fov;
    view.camera.lens.reset();
  }
  return view;
}

}  // namespace relume
