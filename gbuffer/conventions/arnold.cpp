// Arnold: the header tells what each AOV holds and how it was filtered, whatever artists call it (research: exr-conventions A.4, measured).
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

std::optional<std::string> told(const ExrFile& file, const std::string& layer, const char* what) {
  for (const Part& part : file.parts())
    if (auto text = text_attribute(part.header, "arnold/aovs/" + layer + "/" + what)) return text;
  return {};
}

/// The source, unless it is a light path expression, which says less than the name does.
std::string known_as(const ExrFile& file, const Layer& layer) {
  const auto source = told(file, layer.name, "source");
  const bool expression = source && source->find_first_of("<>.*[]'") != std::string::npos;
  return source && !source->empty() && !expression ? *source : layer.name;
}

/// closest_filter takes one sample, every other one averages, and what was missed counts as 0.
void note_filter(const ExrFile& file, const std::vector<Layer>&, Reading& reading) {
  for (const char* role : {"position", "normal"}) {
    const auto found = reading.roles.find(role);
    const auto filter = found == reading.roles.end() ? std::nullopt : told(file, found->second.layer, "filter");
    if (filter && *filter != "closest_filter") reading.position_premultiplied = reading.colour_premultiplied = true;
  }
}

}  // namespace

extern const Convention convention_arnold;
const Convention convention_arnold{
    .name = "arnold",
    .title = "Arnold 5 to 7",
    .source = "arnold-usd e98a4c3 and Cryptomatte sample files, measured; Arnold User Guide, AOVs",
    .marks = {{.attribute = "arnold/*"}},
    .aliases = {{"normal", {"N"}, Says::world},
                {"base_normal", {"Ng"}},
                {"position", {"P"}, Says::world},
                {"depth", {"Z"}},
                {"albedo", {"diffuse_albedo", "albedo", "base_color"}},
                {"coverage", {"", "RGBA"}}},
    .known_as = known_as,
    .assign = note_filter,
};

}  // namespace relume
