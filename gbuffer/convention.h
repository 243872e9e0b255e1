// A convention: one renderer's way of writing, mostly as data: what it is known by, what its layers are called, and what those names imply.
#pragma once

#include <string>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

class Samples;

/// Something that shows who wrote a file. Whatever of it is given has to be there; a * at a name's end stands for any ending.
struct Mark {
  const char* attribute = nullptr;    ///< of any part's header, compared without regard to case: "arnold/*"
  const char* text = nullptr;         ///< part of that attribute's text: "karma"
  std::vector<const char*> layers{};  ///< their names, compared normalised
};

/// What a layer's name tells beyond its role.
enum class Says {
  nothing,
  world,
  camera,          ///< x right, y up, z out of the scene
  camera_forward,  ///< the same with z into the scene
  view_ray,        ///< Space::view_ray
  distance         ///< depth along the ray
};

/// Layers that play a role where they bear one of these names; an earlier name wins over a later one.
struct Alias {
  const char* role;
  std::vector<const char*> names;
  Says says = Says::nothing;
};

struct Convention {
  const char* name = "";      ///< "mitsuba"
  const char* title = "";     ///< "Mitsuba 3, aov integrator"
  const char* source = "";    ///< where its facts come from
  std::vector<Mark> marks{};  ///< any of them will do; without any, and without `recognise`, every file will
  std::vector<Alias> aliases{};
  bool takes_common_names = true;  ///< roles left open go to layers that are named as people commonly name them (gbuffer/common_names.h)
  bool writes_again = false;       ///< a tool whose mark says who wrote the file last, and not who rendered it: any renderer's mark comes first
  Facing facing = Facing::as_stored;
  bool colour_premultiplied = false;
  /// What marks cannot say: the evidence, or empty; and the same in general words. May be null.
  std::string (*recognise)(const ExrFile& file, const std::vector<Layer>& layers) = nullptr;
  const char* recognised_by = "";
  /// The name that a layer goes by, where that is not its own (Arnold's header tells what a renamed AOV holds). May be null.
  std::string (*known_as)(const ExrFile& file, const Layer& layer) = nullptr;
  /// What the lists cannot say, from names and header alone, after them. May be null.
  void (*assign)(const ExrFile& file, const std::vector<Layer>& layers, Reading& reading) = nullptr;
  /// What --diffuse and --specular auto mean, from the roles there are.
  void (*choose_lobes)(Reading& reading) = nullptr;  ///< null: choose_common_lobes
  /// Settles from the data, before a camera is sought, what the names do not say of the spaces; may be null. After --map and options.
  void (*settle_space)(Samples& samples, const ReadingOptions& options, Reading& reading) = nullptr;
  /// Settles the rest, with the camera known if there is one (Mitsuba's bump frame); may be null.
  void (*settle)(Samples& samples, const ReadingOptions& options, Reading& reading) = nullptr;
};

const std::vector<Convention>& conventions();

/// What of a file speaks for a convention, and how much.
struct Evidence {
  int weight = 0;     ///< 0: nothing; more is surer: a tool's mark, names of layers, the renderer's header
  std::string words;  ///< "header attribute arnold/version"
};
Evidence evidence_for(const Convention& convention, const ExrFile& file, const std::vector<Layer>& layers);

/// Roles, spaces and lobes from names and header alone. `layers` are those of the chosen part, view layer and view.
void assign_roles(const Convention& convention, const ExrFile& file, const std::vector<Layer>& layers, Reading& reading);

/// glTF's lobes where a layer tells how rough the surface is, else diffuse light alone.
void choose_common_lobes(Reading& reading);

/// The convention's marks in words: "header arnold/*; layers Ns, dzdx, dzdy".
std::string marks_in_words(const Convention& convention);

}  // namespace relume
