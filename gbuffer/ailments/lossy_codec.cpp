// Codecs made for pictures, on channels that are data (OpenEXR: ImfDwaCompressor.cpp's channel rules, ImfB44Compressor.cpp, ImfPxr24Compressor.cpp).
#include <algorithm>
#include <cctype>
#include <set>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

/// DWA goes by the last part of a name: these are quantised by what an eye would miss, alpha and all others are kept.
bool picture_to_dwa(const std::string& channel) {
  std::string last = channel.substr(channel.rfind('.') + 1);
  std::transform(last.begin(), last.end(), last.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  static const std::set<std::string> names{"r", "g", "b", "y", "by", "ry"};
  return names.contains(last);
}

struct Loss {
  Severity severity;
  std::string why;  ///< empty: the codec keeps the channel
};

Loss loss_of(Imf::Compression codec, const std::string& channel, SampleType type) {
  const bool dwa = codec == Imf::DWAA_COMPRESSION || codec == Imf::DWAB_COMPRESSION;
  if (dwa && type != SampleType::uint32 && picture_to_dwa(channel)) return {Severity::defect, "DWA quantises channels of this name as colour"};
  const bool b44 = codec == Imf::B44_COMPRESSION || codec == Imf::B44A_COMPRESSION;
  if (b44 && type == SampleType::half_float) return {Severity::defect, "B44 keeps 14 bytes of 32"};
  if (codec == Imf::PXR24_COMPRESSION && type == SampleType::float32) return {Severity::hint, "PXR24 rounds floats to 24 bits, about 1 in 65536"};
  return {Severity::hint, ""};
}

bool is_data(const std::string& role) {
  static const std::set<std::string> data{"normal", "position", "base_normal", "tangent", "depth", "ids", "uv"};
  return data.contains(role);
}

std::string effect_of(Severity severity) {
  return severity == Severity::defect ? "directions, places or objects are off in blocks: stripes and patches under near lights" : "hardly any";
}

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  for (const auto& [role, layer] : patient.reading.roles) {
    if (!is_data(role)) continue;
    std::string channels;
    Loss worst{Severity::hint, ""};
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      const Loss loss = loss_of(patient.part_of(role).header.compression(), layer.channels[c], layer.types[c]);
      if (loss.why.empty()) continue;
      channels += (channels.empty() ? "" : ", ") + printable(layer.channels[c]);
      worst = loss;
    }
    if (!channels.empty())
      findings.push_back({"",
                          worst.severity,
                          layer.layer,
                          {},
                          "lossy compression of " + role + " (" + channels + "): " + worst.why,
                          effect_of(worst.severity),
                          "write data with ZIP, ZIPS or PIZ"});
  }
}

}  // namespace

extern const Ailment ailment_lossy_codec;
const Ailment ailment_lossy_codec{"lossy_codec", "lossy compression of data", examine};

}  // namespace relume
