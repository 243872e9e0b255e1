// RowBand: what a kernel needs to know of rows that are no pixels.
#include "host/row_band.h"

#include <algorithm>

namespace relume {
namespace {

constexpr int most_planes = 256;  // two for each parameter's component at most, and the cosines

}  // namespace

RowBand::RowBand(std::span<const PreciseCosines> cosines)
    : gbuffer_{{0, 0, int(cosines.size()), 1}, Planes(cosines.size(), most_planes), {}, {}, {}, {}, false, {}, {}, 0, 0} {
  gbuffer_.position = {gbuffer_.planes.add(9), 9};
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    const PreciseCosines& c = cosines[i];
    const double values[] = {c.n_l, c.n_v, c.l_v, c.sum2, c.across2, c.along2, c.tan2_h, c.chord2, c.r_l};
    for (int k = 0; k < 9; ++k) gbuffer_.planes.plane(gbuffer_.position.first + k)[i] = float(values[k]);
  }
  gbuffer_.coverage = {gbuffer_.planes.add(), 1};
  std::fill_n(gbuffer_.planes.plane(gbuffer_.coverage.first), cosines.size(), 1.0f);
}

void RowBand::add_parameter(const std::string& name, std::span<const std::vector<double>> columns) {
  // Cycles' `albedo` is the kernel's base colour (host/lobes.h).
  for (const std::string& role : name == "albedo" ? std::vector<std::string>{"albedo", "base_color"} : std::vector<std::string>{name}) {
    const int count = int(columns.size());
    const PlaneRange range{gbuffer_.planes.add(count), count};
    for (int c = 0; c < count; ++c) std::copy(columns[std::size_t(c)].begin(), columns[std::size_t(c)].end(), gbuffer_.planes.plane(range.first + c));
    gbuffer_.roles[role] = range;
    reading_.roles[role] = {};
  }
}

Planes RowBand::run(Device& device, const Binding& binding, Entry entry, const Choice& choice) {
  Frame frame{};
  frame.pixels = int(gbuffer_.window.pixels());
  frame.plane_stride = int(gbuffer_.planes.stride());
  frame.position = gbuffer_.position.first;
  frame.base_normal = -1;
  frame.total = frame.ambient_out = -1;
  frame.diffuse = 0;
  frame.specular = 3;
  binding.bind(gbuffer_, Camera{}, frame);
  Planes out(gbuffer_.planes.pixels(), 6);
  out.add(6);
  frame.out_stride = int(out.stride());
  const auto band = device.bind({&gbuffer_.planes, {}, {}, binding.tables(), &out});
  band->run(entry, choice, frame);
  band->finish();
  return out;
}

Planes RowBand::evaluate(Device& device, const Binding& binding) { return run(device, binding, Entry::evaluate, binding.programs().front()); }

Planes RowBand::terms(Device& device, const Binding& binding, int distribution) {
  Choice choice = binding.programs().front();
  choice.diffuse = DIFFUSE_none;  // lobes are not asked: without them a program is small
  choice.specular = SPECULAR_none;
  choice.distribution = distribution;
  return run(device, binding, Entry::terms, choice);
}

}  // namespace relume
