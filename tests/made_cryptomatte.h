// Made-up files with a Cryptomatte, for tests: a frame of 8 x 2 pixels whose objects and shares are known.
#pragma once

#include <ImfStringAttribute.h>

#include <bit>
#include <cctype>
#include <string>
#include <vector>

#include "gbuffer/cryptomatte_id.h"
#include "tests/made_up_exr.h"

namespace relume {

inline double sample_of(std::uint32_t id) { return double(std::bit_cast<float>(id)); }

/// A frame of 8 x 2 pixels: the first rank covers 0.75 with "left" or "right", the second a quarter with "floor"; the last column is empty.
struct Frame8 {
  static double value(const std::string& channel, int x, int) {
    const char letter = char(std::tolower(channel[channel.rfind('.') + 1]));
    const bool first = channel.find("00.") != std::string::npos;
    if (channel.starts_with("P.")) return letter == 'x' ? x : letter == 'z' ? -5 : 0;
    if (channel.starts_with("N.")) return letter == 'z';
    if (!first || x == 7) return 0;
    switch (letter) {
      case 'r':
        return sample_of(cryptomatte_id(x < 4 ? "left" : "right"));
      case 'g':
        return 0.75;
      case 'b':
        return sample_of(cryptomatte_id("floor"));
      default:
        return 0.25;
    }
  }
};

inline MadeUpExr::Edit metadata(const std::string& name, const std::string& manifest, const std::string& prefix = "cryptomatte/1a2b3c4/") {
  return [=](Imf::Header& header) {
    header.insert(prefix + "name", Imf::StringAttribute(name));
    header.insert(prefix + "hash", Imf::StringAttribute("MurmurHash3_32"));
    header.insert(prefix + "conversion", Imf::StringAttribute("uint32_to_float32"));
    if (!manifest.empty()) header.insert(prefix + "manifest", Imf::StringAttribute(manifest));
  };
}

inline const std::vector<std::string> geometry{"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"};

inline std::vector<std::string> with_geometry(const std::vector<std::string>& more) {
  std::vector<std::string> all = geometry;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace relume
