// pbrt-v4's GBufferFilm: shading normals Ns, positions P, premultiplied Albedo, world or camera space unsaid (research: pbrt-truth).
#include <algorithm>

#include "gbuffer/camera_header.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"
#include "gbuffer/samples.h"

namespace relume {
namespace {

/// The file does not tell its materials.
void choose_lobes(Reading& reading) {
  reading.default_diffuse = "lambert";
  reading.default_specular = "none";
  reading.notes.push_back(
      "a pbrt file does not tell its materials: Lambert with the stored albedo is taken (--diffuse, --specular and --set say otherwise)");
}

/// P is a mean over what was hit, albedo one over the pixel.
void set_filtering(const ExrFile&, const std::vector<Layer>&, Reading& reading) { reading.mean_over_hits = true; }

std::optional<Camera> stored_camera(const ExrFile& file, const Reading& reading) {
  const auto cameras = header_cameras(file.parts()[std::size_t(reading.part)].header, reading.display_window);
  if (cameras.empty()) return {};
  return cameras.front();
}

/// Which space P, N and Ns are in, the file does not say: positions will tell (gbuffer/solver/position_space.cpp), given the camera.
void settle_space(Samples& samples, const ReadingOptions& options, Reading& reading) {
  reading.camera = stored_camera(samples.file(), reading);
  if (!reading.camera && !options.position_space)
    reading.notes.push_back("no worldToCamera: positions are taken to be in world space (--position-space camera says otherwise)");
  if (!options.normal_space) reading.normal_space = reading.position_space;
}

}  // namespace

extern const Convention convention_pbrt;
const Convention convention_pbrt{
    .name = "pbrt",
    .title = "pbrt-v4, Film \"gbuffer\"",
    .source = "pbrt-v4 5f7a606, measured; src/pbrt/film.cpp",
    .marks = {{.layers = {"dzdx", "dzdy", "Ns"}}, {.attribute = "samplesPerPixel", .layers = {"Ns", "P"}}},
    // Ns is what pbrt shades with; N is the facet's. Until June 2023 components had no dot: Nsx, Px.
    .aliases = {{"position", {"P"}}, {"normal", {"Ns"}}, {"albedo", {"Albedo"}}, {"uv", {"uv"}}},
    .takes_common_names = false,
    .facing = Facing::two_sided,
    .colour_premultiplied = true,
    .assign = set_filtering,
    .choose_lobes = choose_lobes,
    .settle_space = settle_space,
};

}  // namespace relume
