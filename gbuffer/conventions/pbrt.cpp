// pbrt-v4's GBufferFilm: shading normals Ns, positions P, premultiplied Albedo, world or camera space unsaid (research: pbrt-truth).
#include <algorithm>

#include "gbuffer/camera_header.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"

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

/// Which space P, N and Ns are in, the file does not say: positions will tell (gbuffer/solver/position_space.cpp), given the camera.
void settle_space(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  reading.camera = stored_camera(file, reading);
  if (!reading.camera && !options.position_space)
    reading.notes.push_back("no worldToCamera: positions are taken to be in world space (--position-space camera says otherwise)");
  if (!options.normal_space) reading.normal_space = reading.position_space;
}

}  // namespace

extern const Convention convention_pbrt;
const Convention convention_pbrt{
    "pbrt", "pbrt-v4, Film \"gbuffer\"", "pbrt-v4 5f7a606, measured; src/pbrt/film.cpp", recognise, assign_roles, settle_space, nullptr};

}  // namespace relume
