// Cryptomattes: which objects share a pixel and how much of it each covers, as ranks of ids and coverage (Psyop, Cryptomatte specification 1.2.0).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gbuffer/cryptomatte_manifest.h"
#include "gbuffer/reading.h"

namespace relume {

/// Roles of a G-buffer that begin so hold a Cryptomatte's level: bits and shares, which nothing may scale.
inline constexpr std::string_view cryptomatte_role = "cryptomatte:";

/// One set of objects: "CryptoObject", with its layers CryptoObject00, CryptoObject01, ... of two ranks each.
struct Cryptomatte {
  std::string name;               ///< as the header has it, else its layers' without digits
  std::vector<RoleLayer> levels;  ///< channels: id, coverage, and the same of a second rank
  int header_part = -1;           ///< whose header tells of it; -1: none does, it is taken for one by its layers' names
  std::string key;                ///< there: its attributes begin with this ("cryptomatte/1a2b3c4/")
  bool names_hash_to_ids = true;  ///< false: made with another hash, so that only the manifest knows names
  std::string defect;             ///< why its ids cannot be used; empty where they can

  std::size_t ranks() const;
};

/// Those of the chosen view layer and view, in the order of the file's layers.
std::vector<Cryptomatte> cryptomattes_of(const ExrFile& file, const Reading& reading);

/// Whether a person means this Cryptomatte: its name, or a layer's of it, with or without the view layer, case, spaces, '_', '-' and '.' aside.
bool goes_by(const Cryptomatte& cryptomatte, const std::string& name);

Manifest manifest_of(const ExrFile& file, const Cryptomatte& cryptomatte);

}  // namespace relume
