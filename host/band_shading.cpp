// Frames of a band for the kernels, and linked groups' light put together.
#include "host/band_shading.h"

#include <algorithm>
#include <numbers>
#include <sstream>
#include <utility>

#include "host/band_frame.h"

namespace relume {

BandShading::BandShading(Device& device, const Binding& binding, const LightLinks& lights, const OutputLayout& layout, const Reading& reading,
                         double error, const EnvironmentOptions& environments)
    : device_(device),
      binding_(binding),
      lights_(lights),
      layout_(layout),
      reading_(reading),
      error_(error),
      environments_(lights.environments(), environments, binding.tables()),
      records_(lights.records()) {
  // A bumped normal's shadow is no part of the lobes that are bounded, and between the entries of a measured table anything may lie.
  const std::vector<Choice>& programs = binding.programs();
  const bool measured = std::any_of(programs.begin(), programs.end(), [](const Choice& c) { return c.specular == SPECULAR_merl; });
  const bool bounded = !measured && (reading.bump_shadowing == BumpShadowing::none || !reading.roles.contains("base_normal"));
  for (const LightGroup& group : lights.groups()) {
    trees_.push_back(error > 0 && bounded ? LightTree(records_, group.begin) : LightTree());
    sorted_.emplace_back(lights.records(), group.begin, trees_.back());
    statistics_.lights += int(trees_.back().order().size());
  }
}

Frame BandShading::frame_of(const GBuffer& gbuffer, const Planes& out) const {
  Frame frame = band_frame(gbuffer, reading_, out);
  frame.nodes = binding_.ambient_nodes_begin();
  frame.node_count = binding_.ambient_node_count();
  frame.total = OutputLayout::total;
  frame.diffuse = layout_.diffuse;
  frame.specular = layout_.specular;
  frame.ambient_out = layout_.ambient;
  frame.error = -1;
  return frame;
}

void BandShading::add_irradiance(GBuffer& gbuffer, Irradiance& irradiance, const Progress& progress) const {
  const std::vector<LightGroup>& groups = lights_.groups();
  Planes out(std::size_t(gbuffer.window.pixels()), 3 * int(groups.size()));
  out.add(3 * int(groups.size()));
  Frame frame = frame_of(gbuffer, out);
  frame.diffuse = frame.specular = frame.ambient_out = -1;
  frame.program = 0;
  binding_.bind_irradiance(gbuffer, frame);
  LightLists lists;
  const Choice lambert{DIFFUSE_lambert, SPECULAR_none, 0, 0, 0};
  const std::vector<int> starts = list_lights(gbuffer, frame, {&lambert, 1}, lists);
  frame.environment.scramble = environments_.scramble(gbuffer);
  const auto band = device_.bind({&gbuffer.planes, records_, lists.numbers(), environments_.tables(), &out});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::copy(groups[g].begin.begin(), groups[g].begin.end(), frame.light_begin);
    frame.lists = starts[g];
    frame.total = 3 * int(g);
    band->shade(lambert, frame, progress);
    for (const RigLight& light : lights_.lights())
      if (light.group == int(g) && light.environment >= 0) environments_.add(*band, lambert, frame, light.environment, progress);
  }
  band->finish();
  for (std::size_t g = 1; g < groups.size(); ++g) add_weighed(out, 3 * int(g), 0, weights_of(groups[g], gbuffer));
  for (int c = 0; c < 3; ++c)
    for (std::int64_t i = 0; i < gbuffer.window.pixels(); ++i) irradiance.sum[c] += out.plane(c)[i];
  irradiance.surface_pixels += double(gbuffer.surface_pixels);
}

void BandShading::set_ambient(const glm::dvec3& mean_irradiance) {
  ambient_.clear();
  for (const LightGroup& group : lights_.groups()) ambient_.push_back(group.ambient + group.ambient_fraction / std::numbers::pi * mean_irradiance);
}

void BandShading::shade(GBuffer& gbuffer, Planes& out, Stopwatch& watch, const Progress& progress) const {
  Frame bound = frame_of(gbuffer, out);
  binding_.bind(gbuffer, *reading_.camera, bound);
  watch.lap("bind");
  LightLists lists;
  const std::vector<int> starts = list_lights(gbuffer, bound, binding_.programs(), lists);
  watch.lap("cull");
  bound.environment.scramble = environments_.scramble(gbuffer);
  const auto band = device_.bind({&gbuffer.planes, records_, lists.numbers(), environments_.tables(), &out});
  for (std::size_t g = 0; g < lights_.groups().size(); ++g) {
    Frame frame = bound;
    aim(frame, g);
    frame.lists = starts[g];
    frame.error = error_plane();
    shade_programs(*band, frame, progress);
    for (const RigLight& light : lights_.lights())
      if (light.group == int(g)) add_environment(*band, frame, light, progress);
  }
  if (layout_.lights >= 0) shade_lights(*band, bound, progress);
  band->finish();
  watch.lap("shade");
  if (lights_.groups().size() == 1) return;
  add_linked(gbuffer, out, bound);
  watch.lap("link");
}

/// Each group's Frame::lists.
std::vector<int> BandShading::list_lights(const GBuffer& gbuffer, const Frame& frame, std::span<const Choice> programs, LightLists& lists) const {
  const std::size_t most = LightLists::room_beside(gbuffer.planes);
  FrameBounds bounds(gbuffer.planes, frame, gbuffer.window.width());
  std::vector<int> starts;
  for (std::size_t g = 0; g < sorted_.size(); ++g) {
    Frame of_group = frame;
    std::copy(lights_.groups()[g].begin.begin(), lights_.groups()[g].begin.end(), of_group.light_begin);
    if (trees_[g].empty()) {
      starts.push_back(lists.add(bounds, sorted_[g], most));
      continue;
    }
    const LightCuts cuts(trees_[g], programs, binding_.tables(), error_);
    of_group.lists = lists.add(bounds, sorted_[g], cuts, most + LightLists::room_for_cuts(gbuffer.planes));
    starts.push_back(of_group.lists);
    statistics_.pixels += frame.pixels, statistics_.met += frame.pixels * lights_met(of_group, lists.numbers());
    if (of_group.lists == 0) statistics_.exact += frame.pixels;
  }
  return starts;
}

/// The lights of a group, and where their light goes: the first's into the layout's own planes, each other's behind them.
void BandShading::aim(Frame& frame, std::size_t g) const {
  const LightGroup& group = lights_.groups()[g];
  std::copy(group.begin.begin(), group.begin.end(), frame.light_begin);
  for (int c = 0; c < 3; ++c) frame.ambient[c] = float(ambient_[g][c]);
  frame.ambient[3] = ambient_[g] == glm::dvec3(0) ? 0.0f : 1.0f;
  if (g == 0) return;
  int next = layout_.planes() + int(g - 1) * layout_.colours() * 3;
  for (int* plane : {&frame.total, &frame.diffuse, &frame.specular, &frame.ambient_out})
    if (*plane >= 0) *plane = std::exchange(next, next + 3);
}

void BandShading::shade_programs(Band& band, Frame& frame, const Progress& progress) const {
  for (std::size_t p = 0; p < binding_.programs().size(); ++p) {
    frame.program = int(p);
    frame.width_rule = binding_.width_rule(int(p));
    band.shade(binding_.programs()[p], frame, progress);
  }
}

/// An environment that the device evaluates, beside what is there.
void BandShading::add_environment(Band& band, Frame frame, const RigLight& light, const Progress& progress) const {
  if (light.environment < 0) return;
  for (std::size_t p = 0; p < binding_.programs().size(); ++p) {
    frame.program = int(p);
    frame.width_rule = binding_.width_rule(int(p));
    environments_.add(band, binding_.programs()[p], frame, light.environment, progress);
  }
}

/// Each light alone, into its own layer.
void BandShading::shade_lights(Band& band, Frame frame, const Progress& progress) const {
  frame.diffuse = frame.specular = frame.ambient_out = -1;
  frame.ambient[3] = 0;
  for (std::size_t k = 0; k < lights_.lights().size(); ++k) {
    const RigLight& light = lights_.lights()[k];
    const LightGroup& group = lights_.groups()[std::size_t(light.group)];
    for (int type = 0; type <= LIGHT_COUNT; ++type) frame.light_begin[type] = group.begin[std::size_t(type)] <= light.begin ? light.begin : light.end;
    frame.total = layout_.lights + 3 * int(k);
    if (light.begin < light.end) shade_programs(band, frame, progress);
    add_environment(band, frame, light, progress);
  }
}

/// Linked groups' light, by the share that their objects have of each pixel.
void BandShading::add_linked(const GBuffer& gbuffer, Planes& out, const Frame& bound) const {
  for (std::size_t g = 1; g < lights_.groups().size(); ++g) {
    const LightGroup& group = lights_.groups()[g];
    const std::vector<float> weights = weights_of(group, gbuffer);
    Frame aimed = bound;
    aim(aimed, g);
    add_weighed(out, aimed.total, bound.total, weights);
    for (const auto plane : {&Frame::diffuse, &Frame::specular, &Frame::ambient_out})
      if (bound.*plane >= 0) add_weighed(out, aimed.*plane, bound.*plane, weights);
    if (layout_.lights >= 0)
      for (std::size_t k = 0; k < lights_.lights().size(); ++k)
        if (lights_.lights()[k].group == int(g)) weigh(out, layout_.lights + 3 * int(k), weights);
  }
}

std::string BandShading::tree_sentence() const {
  std::ostringstream text;
  if (statistics_.lights == 0) {
    text << "error " << error_ << ": exact all the same: a light tree needs 64 unranged point lights at least, none of negative intensity, and no "
         << "bump shadowing or measured BRDF";
    return text.str();
  }
  text << "error " << error_ << ": each channel of each pixel is within " << 100 * error_ << "% of brute force; of " << statistics_.lights
       << " unranged lights a pixel meets " << (statistics_.pixels > 0 ? statistics_.met / statistics_.pixels : 0)
       << " lights and stand-ins in the mean";
  if (statistics_.exact > 0) text << "; " << statistics_.exact << " pixels, whose lists did not fit into --memory, are exact";
  return text.str();
}

}  // namespace relume
