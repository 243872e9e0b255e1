// The names of a Cryptomatte's objects: its manifest, in the header or in a file beside the image (Cryptomatte specification 1.2.0, "Manifest").
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relume {

/// What came from a file stays as it was there: names need printable() before they are shown.
struct Manifest {
  std::map<std::string, std::uint32_t> ids;    ///< by name
  std::map<std::uint32_t, std::string> names;  ///< by id; of names that share one, the first
  std::string source;                          ///< "the header", the sidecar's name, or empty: there is none
  std::vector<std::string> notes;              ///< what was wrong with it, one sentence each

  bool empty() const { return ids.empty(); }
};

/// Reads {"name": "8 hex digits", ...}. Never throws: what is not so is left out, and a note says how much.
Manifest parse_manifest(std::string_view json, const std::string& source);

/// The manifest that the header holds or names. `sidecar` is relative to the folder of `exr`; one that leads elsewhere is not opened, and a note says
/// so.
Manifest read_manifest(const std::filesystem::path& exr, const std::optional<std::string>& in_header, const std::optional<std::string>& sidecar);

}  // namespace relume
