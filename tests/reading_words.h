// What a Reading says, in words that tests compare.
#pragma once

#include <string>

#include "gbuffer/reading.h"

namespace relume {

/// The layer of a role, empty where there is none.
inline std::string layer(const Reading& reading, const std::string& role) {
  const auto found = reading.roles.find(role);
  return found == reading.roles.end() ? "" : found->second.layer;
}

/// All notes, a line each.
inline std::string notes(const Reading& reading) {
  std::string text;
  for (const std::string& note : reading.notes) text += note + "\n";
  return text;
}

}  // namespace relume
