// LiveFrame: a base of the lights that stand still, and the held one on top of it.
#include "host/live_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "gbuffer/error.h"
#include "host/band_frame.h"
#include "host/json.h"
#include "host/light_reach.h"

namespace relume {

LiveFrame::LiveFrame(Device& device, GBuffer gbuffer, const Binding& binding, const Reading& reading)
    : device_(device), binding_(binding), gbuffer_(std::move(gbuffer)), out_(std::size_t(gbuffer_.samples()), planes) {
  out_.add(planes);
  frame_ = band_frame(gbuffer_, reading, out_);
  frame_.nodes = binding.ambient_nodes_begin();
  frame_.node_count = binding.ambient_node_count();
  binding.bind(gbuffer_, *reading.camera, frame_);
  bounds_.emplace(gbuffer_.planes, frame_, gbuffer_.window.width());
}

void LiveFrame::check(const Light& light) const {
  const std::string who = "light " + in_quotes(light.name);
  if (!light.include.empty() || !light.exclude.empty())
    throw Error(ErrorKind::input, who + ": is linked to objects, which a live frame does not know");
  if (light.fraction) throw Error(ErrorKind::input, who + ": is a fraction of the frame's mean (give an intensity)");
}

void LiveFrame::set_lights(std::vector<Light> lights) {
  for (const Light& light : lights) check(light);
  lights_ = std::move(lights);
  held_.reset();
  shade_all(light_records(lights_), 0);
}

void LiveFrame::change_light(std::size_t number, const Light& light) {
  if (number >= lights_.size()) throw Error(ErrorKind::input, "no light " + std::to_string(number) + " (has " + std::to_string(lights_.size()) + ")");
  check(light);
  const bool ambient_changes = light.type == LightType::ambient || lights_[number].type == LightType::ambient;
  if (ambient_changes) {
    std::vector<Light> lights = lights_;
    lights[number] = light;
    return set_lights(std::move(lights));
  }
  const LightRecords before = light_records({lights_[number]}), now = light_records({light});
  const bool is_held = held_ == number;
  if (!is_held) hold(number);
  lights_[number] = light;
  shade(now, is_held ? lists_of(before, now) : std::vector<int>{}, 0, sums);
}

/// The picture lacks the held light until it is shaded for all pixels.
void LiveFrame::hold(std::size_t number) {
  std::vector<Light> others = lights_;
  others.erase(others.begin() + std::ptrdiff_t(number));
  shade_all(light_records(others), sums);
  held_ = number;
}

void LiveFrame::shade_all(const LightRecords& lights, int sums_out) {
  const SortedLights sorted(lights.records, lights.begin);
  lists_.clear();
  const int start = lists_.add(*bounds_, sorted, LightLists::room_beside(gbuffer_.planes));
  shade(lights, start > 0 ? lists_.numbers() : std::span<const int>(), sums_out, 0);
  touched_ = 1;
}

std::vector<int> LiveFrame::lists_of(const LightRecords& before, const LightRecords& now) {
  const LightReach reach_before(before.records, before.begin), reach_now(now.records, now.begin);
  const std::size_t blocks = (std::size_t(frame_.pixels) + PixelCells::block - 1) / PixelCells::block;
  std::vector<int> numbers(1 + 2 * blocks, -1);  // Frame::lists is 1: 0 would mean none
  const int empty = int(numbers.size());
  numbers.push_back(0);
  const PixelCells& pixels = bounds_->pixels();
  const CellBounds& cells = bounds_->last();
  std::atomic<std::size_t> touched = 0;
  tbb::parallel_for(0, pixels.cells_down(), [&](int row) {
    thread_local std::vector<int> found;
    std::size_t touched_here = 0;
    const auto reaches = [&](const LightReach& reach, std::span<const PixelBounds> cell) {
      found.clear();
      reach.add_lighting(cell, found);
      return !found.empty();
    };
    for (int column = 0; column < pixels.columns(); ++column) {
      const std::span<const PixelBounds> cell = cells.of(row, column);
      if (cell.empty()) continue;
      const bool lit = reaches(reach_now, cell);
      if (!lit && !reaches(reach_before, cell)) continue;
      for (int y = row * PixelCells::cell_rows; y < (row + 1) * PixelCells::cell_rows; ++y) {
        const int block = pixels.block_at(y, column);
        if (block < 0) continue;
        numbers[1 + 2 * std::size_t(block)] = empty;
        numbers[2 + 2 * std::size_t(block)] = empty + lit;
        ++touched_here;
      }
    }
    touched += touched_here;
  });
  touched_ = blocks ? double(touched) / double(blocks) : 0;
  return numbers;
}

void LiveFrame::shade(const LightRecords& lights, std::span<const int> lists, int sums_out, int base) {
  Frame frame = frame_;
  std::copy(lights.begin.begin(), lights.begin.end(), frame.light_begin);
  frame.lists = lists.empty() ? 0 : 1;
  frame.sums = sums_out;
  frame.base = base;
  // What is not there need not be read from beside the picture.
  const bool any = std::any_of(lights_.begin(), lights_.end(), [](const Light& light) { return light.type == LightType::ambient; });
  frame.ambient_out = any ? ambient : -1;
  for (int c = 0; c < 3; ++c) frame.ambient[c] = float(lights.ambient[c]);
  frame.ambient[3] = lights.ambient == glm::dvec3(0) ? 0.0f : 1.0f;
  const auto band = device_.bind({&gbuffer_.planes, lights.records, lists, binding_.tables(), &out_});
  for (std::size_t p = 0; p < binding_.programs().size(); ++p) {
    frame.program = int(p);
    frame.width_rule = binding_.width_rule(int(p));
    band->shade(binding_.programs()[p], frame, {});
  }
  band->finish();
}

}  // namespace relume
