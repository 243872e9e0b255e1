// The twin as a device: its widest compilation that this processor runs, over all cores.
#include "host/twin.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "gbuffer/error.h"
#include "host/light_lists.h"

namespace relume {

using ShadeRange = void (*)(const Choice&, const float*, const Frame&, const LightRecord*, const int*, const float*, float*, int, int);
using BoundCell = void (*)(const float*, const Frame&, const int*, int, PixelBounds&);
using EvaluateRange = void (*)(const Choice&, const float*, const Frame&, const float*, float*, int, int);

#define RELUME_TWIN(lanes)                                                                                                     \
  namespace lanes {                                                                                                            \
  void shade_range(const Choice&, const float*, const Frame&, const LightRecord*, const int*, const float*, float*, int, int); \
  void evaluate_range(const Choice&, const float*, const Frame&, const float*, float*, int, int);                              \
  void bound_cell(const float*, const Frame&, const int*, int, PixelBounds&);                                                  \
  }
RELUME_TWIN(lanes1)
RELUME_TWIN(lanes4)
RELUME_TWIN(lanes8)
RELUME_TWIN(lanes16)

namespace {

struct Compilation {
  int lanes;
  ShadeRange shade;
  EvaluateRange evaluate;
  BoundCell bound;
  bool runs_here;
};

const std::vector<Compilation>& compilations() {
#if defined(__x86_64__)
  static const std::vector<Compilation> all{
      {1, lanes1::shade_range, lanes1::evaluate_range, lanes1::bound_cell, true},
      {4, lanes4::shade_range, lanes4::evaluate_range, lanes4::bound_cell, true},
      {8, lanes8::shade_range, lanes8::evaluate_range, lanes8::bound_cell, __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")},
      {16, lanes16::shade_range, lanes16::evaluate_range, lanes16::bound_cell, bool(__builtin_cpu_supports("avx512f"))}};
#else
  static const std::vector<Compilation> all{{1, lanes1::shade_range, lanes1::evaluate_range, lanes1::bound_cell, true},
                                            {4, lanes4::shade_range, lanes4::evaluate_range, lanes4::bound_cell, true},
                                            {8, lanes8::shade_range, lanes8::evaluate_range, lanes8::bound_cell, true},
                                            {16, lanes16::shade_range, lanes16::evaluate_range, lanes16::bound_cell, true}};
#endif
  return all;
}

class TwinBand : public Band {
 public:
  TwinBand(const Compilation& compilation, const BandData& data) : compilation_(compilation), data_(data) {}

  void shade(const Choice& choice, const Frame& frame, const Progress& progress) override {
    // About 0.1 s of work between two looks at the interrupt flag; blocks of 1024 pixels share the cores.
    const std::int64_t lights = lights_met(frame, data_.lists), unit = Planes::granule;
    const std::int64_t slice = std::max<std::int64_t>(1, 20'000'000 / lights / unit) * unit;
    for (std::int64_t first = 0; first < frame.pixels; first += slice) {
      const std::int64_t last = std::min<std::int64_t>(first + slice, frame.pixels);
      tbb::parallel_for(tbb::blocked_range<std::int64_t>(first / unit, (last + unit - 1) / unit), [&](const auto& range) {
        const int begin = int(range.begin() * unit), end = int(std::min<std::int64_t>(range.end() * unit, last));
        compilation_.shade(choice, data_.planes->data(), frame, data_.lights.data(), data_.lists.data(), data_.tables.data(), data_.out->data(),
                           begin, end);
      });
      if (progress) progress(last - first);
    }
  }

  void evaluate(const Choice& choice, const Frame& frame) override {
    compilation_.evaluate(choice, data_.planes->data(), frame, data_.tables.data(), data_.out->data(), 0, frame.pixels);
  }

  void finish() override {}

 private:
  const Compilation& compilation_;
  BandData data_;
};

class TwinDevice : public Device {
 public:
  explicit TwinDevice(const Compilation& compilation) : compilation_(compilation) {
    info_.name = "twin";
    info_.platform = "C++";
    info_.vendor = "relume";
    info_.version = RELUME_VERSION;
    info_.is_cpu = true;
    info_.lanes = compilation.lanes;
    info_.correctly_rounded = true;
    info_.max_allocation = info_.memory = std::uint64_t(1) << 46;
  }
  const DeviceInfo& info() const override { return info_; }
  std::unique_ptr<Band> bind(const BandData& data) override { return std::make_unique<TwinBand>(compilation_, data); }

 private:
  DeviceInfo info_;
  const Compilation& compilation_;
};

}  // namespace

std::vector<int> twin_lanes() {
  std::vector<int> lanes;
  for (const Compilation& c : compilations())
    if (c.runs_here) lanes.push_back(c.lanes);
  return lanes;
}

void bound_cell(const float* planes, const Frame& frame, const int* blocks, int count, PixelBounds& bounds) {
  static const BoundCell widest = [] {
    BoundCell found = nullptr;
    for (const Compilation& c : compilations())
      if (c.runs_here) found = c.bound;
    return found;
  }();
  widest(planes, frame, blocks, count, bounds);
}

std::unique_ptr<Device> open_twin(int lanes) {
  const std::vector<int> possible = twin_lanes();
  const int wanted = lanes == 0 ? possible.back() : lanes;
  for (const Compilation& c : compilations())
    if (c.runs_here && c.lanes == wanted) return std::make_unique<TwinDevice>(c);
  std::string list;
  for (const int l : possible) list += (list.empty() ? "" : ", ") + std::to_string(l);
  throw Error(ErrorKind::device, "the twin has no " + std::to_string(wanted) + " lanes on this processor (has: " + list + ")");
}

}  // namespace relume
