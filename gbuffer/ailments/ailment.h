// What a G-buffer can suffer from: an ailment is a file in this folder and a line in list.h.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/ailments/row.h"
#include "gbuffer/ailments/tally.h"
#include "gbuffer/exr_file.h"
#include "gbuffer/reading.h"

namespace relume {

enum class Severity {
  hint,   ///< worth knowing; the picture is as good as the file allows
  defect  ///< changes pixels of the picture
};

struct Finding {
  std::string ailment;  ///< its name in list.h
  Severity severity = Severity::hint;
  std::string layer;           ///< which layer, as a person would write it for --map; empty: the file
  std::optional<Tally> where;  ///< empty: the file as a whole
  std::string what;            ///< one sentence each: what it is, with numbers
  std::string effect;          ///< what it does to the picture
  std::string cure;            ///< the option that mends it
};

/// What is known before the pixels are looked at.
struct Patient {
  const ExrFile& file;
  const Reading& reading;          ///< as far as the file could be understood
  bool understood = true;          ///< false: the reading is names alone
  std::vector<glm::dvec3> lights;  ///< places of the lights that have one; empty: none were given

  bool has(const std::string& role) const { return reading.roles.contains(role); }
  const RoleLayer& layer(const std::string& role) const { return reading.roles.at(role); }
  const Part& part_of(const std::string& role) const { return file.parts()[std::size_t(layer(role).part)]; }
};

/// One thing to look for in the pixels. Rows come in any order and many at once: what is found goes into the tallies and nowhere else.
struct Check {
  std::vector<std::string> roles;  ///< those that `look` asks the row for, beside normal, position, depth and coverage; the file may lack them
  int tallies = 1;
  std::function<void(const Row&, std::span<Tally>)> look;
  std::function<void(std::span<const Tally>, std::vector<Finding>&)> conclude;
};

struct Ailment {
  const char* name;   ///< "zero_normals"
  const char* title;  ///< "a surface without a normal"
  /// Adds what header and reading tell to the findings, and what has to be looked for to the checks.
  void (*examine)(const Patient&, std::vector<Check>&, std::vector<Finding>&);
};

const std::vector<Ailment>& ailments();

/// "12 % of 2304 pixels"
std::string share_in_words(const Tally& tally);

}  // namespace relume
