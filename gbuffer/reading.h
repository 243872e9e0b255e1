// How a file is to be read: which layer plays which role, in which space and encoding, on what evidence. `inspect` prints it, `shade` obeys it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/camera.h"
#include "gbuffer/layers.h"

namespace relume {

struct Convention;

enum class Space {
  world,
  camera,
  view_ray  ///< normals only: V-Ray's frame of each pixel's own viewing ray (research: exr-conventions A.5)
};
/// "world", "camera", "view ray"
const char* name_of(Space space);
enum class NormalEncoding { as_signed, as_unsigned };  ///< -1..1, or 0..1 for -1..1
enum class DepthKind {
  z,        ///< along the camera's axis
  distance  ///< along the pixel's ray
};

/// How the stored components make up a vector: component i is sign[i] times the stored component from[i]. "x,-y,z" is a flipped green.
struct Axes {
  std::array<int, 3> from{0, 1, 2}, sign{1, 1, 1};
  bool operator==(const Axes&) const = default;
};

/// One question that the file does not answer by itself, how the data answered it, and how sure that is.
struct Verdict {
  std::string question;  ///< "normal space"
  std::string answer;    ///< "camera"
  std::string evidence;  ///< one sentence with numbers: "agrees with the positions' own normals to 0.998 (world: 0.41)"
  std::string option;    ///< what overrules it: "--normal-space"
  bool sure = true;      ///< false: another answer is nearly as good, and the documented default was taken
};

/// What happens where a normal points away from the viewer.
enum class Facing {
  as_stored,  ///< diffuse follows n.l alone, specular needs n.v > 0 (Cycles, and where nothing is known)
  one_sided,  ///< black from behind (Mitsuba)
  two_sided   ///< turned to the viewer (pbrt; a material's "twosided")
};

/// How a shading normal that differs from the surface's own is kept from leaking light.
enum class BumpShadowing {
  none,
  horizon,  ///< no light from below the base normal
  smith     ///< that, and Smith's G1 of a GGX as wide as the tilt (Estevez et al. 2019, "A Microfacet-Based Shadowing Function ...")
};

/// A layer chosen for a role, by its channels: three for a direction or colour, one for a number.
struct RoleLayer {
  int part = 0;
  std::string layer;                  ///< as a person would write it for --map
  std::vector<std::string> channels;  ///< full channel names, in component order
  std::vector<SampleType> types;
};

struct Reading {
  std::string convention;                         ///< a name of conventions()
  std::string evidence;                           ///< why this convention: "header attribute generatedBy = \"Mitsuba version 3.9.1\""
  std::map<std::string, RoleLayer> roles;         ///< by the names of gbuffer/roles.h, and layers that materials name by their own
  std::map<std::string, std::string> looked_for;  ///< the names tried for each role, for the message where none was found
  std::string view_layer, view;                   ///< those chosen, where the file has them
  std::string ids_cryptomatte;                    ///< the Cryptomatte that --map ids=NAME means, if it means one (gbuffer/object_ids.h)
  int part = 0;                                   ///< whose windows and attributes the output takes: the part of `position`
  Window data_window, display_window;
  double pixel_aspect = 1;
  Space position_space = Space::world, normal_space = Space::world;
  NormalEncoding normal_encoding = NormalEncoding::as_signed;
  Axes normal_axes, position_axes;  ///< camera space that points z into the scene (pbrt, 3Delight) is x,y,-z
  DepthKind depth_kind = DepthKind::z;
  double position_scale = 1;             ///< world units for one of the stored positions' (a camera in metres, positions in centimetres)
  bool normal_in_tangent_frame = false;  ///< Mitsuba 3.9's bumpmap: n = s x + t y + base z (research: mitsuba-truth)
  std::vector<std::uint32_t> tangent_ids, bumped_ids;  ///< object ids that the tangent frame, and base normals, concern; empty: all
  bool position_premultiplied = false;  ///< position is a mean over the pixel including misses as 0: divide by coverage, and so is every other layer
  bool mean_over_hits = false;          ///< position is a mean over the samples that hit something, the normal that mean's direction (pbrt)
  bool filtered = false;                ///< pixels are means over several samples: some mix surfaces
  bool colour_premultiplied = false;    ///< albedo and other colours carry coverage, so radiance needs no factor of its own
  double background_depth = 1e9;        ///< depth at or beyond this, or no normal, shows no surface
  Facing facing = Facing::as_stored;
  BumpShadowing bump_shadowing = BumpShadowing::none;
  std::string default_diffuse = "lambert", default_specular = "ggx";  ///< what --diffuse/--specular auto mean for this file
  std::optional<Camera> camera;
  std::vector<Verdict> verdicts;   ///< what the data were asked, in order
  std::vector<std::string> made;   ///< what the file lacked and was made: "position from depth (VRayZDepth) and the header's camera"
  std::vector<std::string> notes;  ///< one sentence each: what was found out from the data and how sure, what was assumed, how to overrule it
};

/// What the user said of the file; empty means "find out".
struct ReadingOptions {
  std::string convention;
  std::optional<int> part;
  std::string view_layer, view;
  std::map<std::string, std::string> map;  ///< role -> layer
  std::optional<Space> normal_space, position_space;
  std::optional<NormalEncoding> normal_encoding;
  std::optional<Axes> normal_axes, position_axes;
  std::optional<double> position_scale;
  std::optional<DepthKind> depth_kind;
  std::optional<bool> premultiplied;  ///< whether layers are means over the pixel that include misses as 0
  std::optional<Facing> facing;
  std::optional<BumpShadowing> bump_shadowing;
  std::optional<Camera> camera;  ///< from a rig, a glTF or another file: wins over the header's; nullopt: header, else recovered
  bool recover_camera = false;   ///< --camera auto: recover from positions even where the header has one
};

/// Understands a file. Throws Error{input} when a needed role is missing ("no normal layer (looked for N, Normal, ...; --map normal=LAYER names
/// one)").
Reading understand(const ExrFile& file, const ReadingOptions& options);

/// Whether a role that the file lacks is made from others: "position" from depth and the camera, "normal" from positions, "albedo" from
/// light with and without it.
bool is_made(const Reading& reading, const std::string& role);

/// The layer that a person means by `name` (for --map and "layer:NAME"): exact, else without regard to case, spaces, '_' and '-', with or without the
/// view layer; among those of the chosen view layer and view. Throws Error{input} that lists the layers there are.
RoleLayer find_layer(const ExrFile& file, const Reading& reading, const std::string& name);

/// The convention that options name, or else the one that most speaks for.
const Convention& convention_of(const ExrFile& file, const ReadingOptions& options);

}  // namespace relume
