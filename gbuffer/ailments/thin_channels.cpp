// Channels that are stored for every second pixel or less: made for video's colour differences, useless for data.
#include <ImfChannelList.h>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  for (const Part& part : patient.file.parts()) {
    std::string names;
    const Imf::ChannelList& channels = part.header.channels();
    for (auto i = channels.begin(); i != channels.end(); ++i)
      if (i.channel().xSampling != 1 || i.channel().ySampling != 1) names += (names.empty() ? "" : ", ") + printable(i.name());
    if (!names.empty())
      findings.push_back({"",
                          patient.understood ? Severity::hint : Severity::defect,
                          "",
                          {},
                          "part " + std::to_string(part.index) + ": channels are stored for some pixels only (subsampled): " + names,
                          "they are not read",
                          "write them at full resolution"});
  }
}

}  // namespace

extern const Ailment ailment_thin_channels;
const Ailment ailment_thin_channels{"thin_channels", "subsampled channels", examine};

}  // namespace relume
