// pbrt-v4's GBufferFilm: shading normals Ns, positions P, premultiplied Albedo, world or camera space unsaid (research: pbrt-truth).
#include <algorithm>
#include <cmath>

#include "gbuffer/camera_header.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"
#include "gbuffer/sample_rows.h"

namespace relume {
namespace {

const Layer* named(const std::vector<Layer>& layers, const std::string& name) {
  const auto found = std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.name == name; });
  return found == layers.end() ? nullptr : &*found;
}

std::string recognise(const ExrFile& file, const std::vector<Layer>& layers) {
  const bool normals = named(layers, "Ns") || named(layers, "Nsx");
  if (!normals) return {};
  if (named(layers, "dzdx") && named(layers, "dzdy")) return named(layers, "Ns") ? "channels dzdx, dzdy and Ns" : "channels dzdx, dzdy and Nsx";
  const Imf::Header& header = file.parts().front().header;
  const bool statistics = number_attribute(header, "samplesPerPixel") && matrix_attribute(header, "worldToNDC");
  return statistics ? "channels Ns, header attributes samplesPerPixel and worldToNDC" : "";
}

/// Until June 2023 vectors were three bare channels: Px, Py, Pz.
void assign_bare(const std::vector<Layer>& layers, Reading& reading, const std::string& role, const std::string& name, const std::string& letters) {
  if (reading.roles.contains(role)) return;
  RoleLayer result{0, name, {}, {}};
  for (const char letter : letters) {
    const Layer* const layer = named(layers, name + letter);
    if (!layer || layer->components.size() != 1) return;
    result.part = layer->part;
    result.channels.push_back(layer->components.front().channel);
    result.types.push_back(layer->components.front().type);
  }
  reading.roles[role] = result;
}

void assign_roles(const ExrFile&, const std::vector<Layer>& layers, Reading& reading) {
  assign(reading, layers, "position", {"P"});
  assign_bare(layers, reading, "position", "P", "xyz");
  assign(reading, layers, "normal", {"Ns"});  // what pbrt shades with; N is the facet's
  assign_bare(layers, reading, "normal", "Ns", "xyz");
  assign(reading, layers, "albedo", {"Albedo"});
  assign_bare(layers, reading, "uv", "", "uv");
  if (const auto uv = reading.roles.find("uv"); uv != reading.roles.end()) uv->second.layer = "uv";
  reading.facing = Facing::two_sided;
  reading.colour_premultiplied = true;
  reading.camera_z_forward = true;
  reading.default_diffuse = "lambert";
  reading.default_specular = "none";
  reading.notes.push_back(
      "a pbrt file does not tell its materials: Lambert with the stored albedo is taken (--diffuse, --specular and --set say otherwise)");
}

/// pbrt's matrices are stored transposed; a file whose matrix is not rigid that way is no pbrt file.
std::optional<Camera> stored_camera(const ExrFile& file, const Reading& reading) {
  const auto cameras = header_cameras(file.parts()[std::size_t(reading.part)].header, reading.display_window);
  if (cameras.empty()) return {};
  return cameras.back();
}

/// The viewer at the origin, x right, y up, z forward: what camera-space positions must reproject with.
Camera camera_space(Camera::Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.world_from_camera[2] *= -1.0;
  return camera;
}

void settle_space(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  const auto camera = stored_camera(file, reading);
  if (!camera) {
    if (!options.position_space)
      reading.notes.push_back("no worldToCamera: positions are taken to be in world space (--position-space camera says otherwise)");
    return;
  }
  std::vector<glm::dvec3> normals;
  const auto sightings = clear_sightings(sample_rows(file, reading, {"position", "normal"}), reading, normals);
  reading.camera = camera;
  if (options.position_space || sightings.empty()) {
    if (!options.normal_space) reading.normal_space = reading.position_space;
    return;
  }
  const PoseFit in_world = fit_pose(*camera, sightings), in_camera = fit_pose(camera_space(camera->projection), sightings);
  const double world = in_world.residual, seen = in_camera.residual;
  reading.position_space = seen < world ? Space::camera : Space::world;
  if (!options.normal_space) reading.normal_space = reading.position_space;
  if (reading.position_space == Space::camera) {
    reading.camera->residual = seen;
    if (seen < 1) set_extent(*reading.camera, in_camera, reading.display_window);
  }
  const auto pixels = [](double v) { return std::isfinite(v) ? std::to_string(v).substr(0, 6) + " px" : std::string("the wrong way round"); };
  reading.notes.push_back(std::string("P, N and Ns are in ") + (seen < world ? "camera" : "world") + " space: reprojected, P misses its pixel by " +
                          pixels(std::min(world, seen)) + " (the other reading: " + pixels(std::max(world, seen)) + ")");
  if (std::min(world, seen) > 1)
    reading.notes.push_back("warning: neither reading of P fits the header's camera (--position-space and --camera decide)");
}

}  // namespace

extern const Convention convention_pbrt;
const Convention convention_pbrt{
    "pbrt", "pbrt-v4, Film \"gbuffer\"", "pbrt-v4 5f7a606, measured; src/pbrt/film.cpp", recognise, assign_roles, settle_space, nullptr};

}  // namespace relume
