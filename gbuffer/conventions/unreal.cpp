// Unreal's Movie Render Queue: passes named FinalImage<Pass>, in a left-handed world in centimetres with z up (research: exr-conventions A.8).
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

/// "FinalImageMovieRenderQueue_WorldNormal" goes by "WorldNormal".
std::string known_as(const ExrFile&, const Layer& layer) {
  std::string name = layer.name;
  for (const std::string_view prefix : {"FinalImage", "PathTracer", "MovieRenderQueue", "_"})
    if (name.size() > prefix.size() && name.starts_with(prefix)) name.erase(0, prefix.size());
  return name;
}

/// Where nothing was hit, a depth in half precision holds the largest number there is.
void set_background(const ExrFile&, const std::vector<Layer>&, Reading& reading) {
  const auto depth = reading.roles.find("depth");
  constexpr double largest_half = 65504;
  if (depth != reading.roles.end() && depth->second.types.front() == SampleType::half_float) reading.background_depth = largest_half;
}

}  // namespace

extern const Convention convention_unreal;
const Convention convention_unreal{
    .name = "unreal",
    .title = "Unreal Engine, Movie Render Queue",
    .source = "third parties' readers of its files; dev.epicgames.com, Cinematic Render Passes (0..1 or -1..1 for normals: the data tell)",
    .marks = {{.attribute = "unreal/*"}, {.layers = {"FinalImage*"}}, {.layers = {"ActorHitProxyMask00"}}},
    .aliases = {{"normal", {"WorldNormal", "Normal"}, Says::world},
                {"position", {"WorldPosition", "AbsoluteWorldPosition", "Position"}, Says::world},
                {"depth", {"WorldDepth", "SceneDepth", "SceneDepthWorldUnits", "Depth"}},
                {"albedo", {"BaseColor", "DiffuseColor"}},
                {"roughness", {"Roughness"}},
                {"metallic", {"Metallic"}}},
    .known_as = known_as,
    .assign = set_background,
};

}  // namespace relume
