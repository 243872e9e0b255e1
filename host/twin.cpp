// The twin as a device: its widest compilation that this processor runs, over all cores.
#include "host/twin.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <functional>

#include "gbuffer/error.h"
#include "host/culling.h"
#include "host/light_lists.h"

namespace relume {

using RunRange = void (*)(const Choice&, const float*, const Frame&, const LightRecord*, const int*, const float*, float*, int, int);

#define RELUME_TWIN_RANGE(name) \
  void name##_range(const Choice&, const float*, const Frame&, const LightRecord*, const int*, const float*, float*, int, int);
#define RELUME_TWIN(lanes)          \
  namespace lanes {                 \
  RELUME_ENTRIES(RELUME_TWIN_RANGE) \
  extern const Culling culling;     \
  }
RELUME_TWIN(lanes1)
RELUME_TWIN(lanes4)
RELUME_TWIN(lanes8)
RELUME_TWIN(lanes16)

namespace {

#define RELUME_COUNT_ENTRY(name) +1
constexpr std::size_t entry_count = 0 RELUME_ENTRIES(RELUME_COUNT_ENTRY);

struct Compilation {
  int lanes;
  std::array<RunRange, entry_count> run;  // by Entry
  const Culling* culling;
  bool runs_here;
};

#if defined(__x86_64__)
const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"), has_avx512 = __builtin_cpu_supports("avx512f");
#else
constexpr bool has_avx2 = true, has_avx512 = true;  // vectors of any width are built of what there is
#endif

const std::vector<Compilation>& compilations() {
#define RELUME_RANGE_1(name) lanes1::name##_range,
#define RELUME_RANGE_4(name) lanes4::name##_range,
#define RELUME_RANGE_8(name) lanes8::name##_range,
#define RELUME_RANGE_16(name) lanes16::name##_range,
  static const std::vector<Compilation> all{{1, {RELUME_ENTRIES(RELUME_RANGE_1)}, &lanes1::culling, true},
                                            {4, {RELUME_ENTRIES(RELUME_RANGE_4)}, &lanes4::culling, true},
                                            {8, {RELUME_ENTRIES(RELUME_RANGE_8)}, &lanes8::culling, has_avx2},
                                            {16, {RELUME_ENTRIES(RELUME_RANGE_16)}, &lanes16::culling, has_avx512}};
  return all;
}

class TwinBand : public Band {
 public:
  TwinBand(const Compilation& compilation, const BandData& data) : compilation_(compilation), data_(data) {}

  void shade(const Choice& choice, const Frame& frame, const Progress& progress) override {
    run_slices(Entry::shade, choice, frame, lights_met(frame, data_.lists), progress);
  }

  void run(Entry entry, const Choice& choice, const Frame& frame) override { run_range(entry, choice, frame, 0, frame.pixels); }

  void add_environment(Entry entry, const Choice& choice, const Frame& frame, const Progress& progress) override {
    run_slices(entry, choice, frame, environment_work, progress);
  }

  void finish() override {}

 private:
  /// About 0.1 s of work between two looks at the interrupt flag; blocks of 1024 pixels share the cores. `work`: what a pixel costs, in lights.
  void run_slices(Entry entry, const Choice& choice, const Frame& frame, std::int64_t work, const Progress& progress) {
    const std::int64_t unit = Planes::granule, slice = std::max<std::int64_t>(1, 20'000'000 / work / unit) * unit;
    for (std::int64_t first = 0; first < frame.pixels; first += slice) {
      const std::int64_t last = std::min<std::int64_t>(first + slice, frame.pixels);
      tbb::parallel_for(tbb::blocked_range<std::int64_t>(first / unit, (last + unit - 1) / unit), [&](const auto& range) {
        run_range(entry, choice, frame, int(range.begin() * unit), int(std::min<std::int64_t>(range.end() * unit, last)));
      });
      if (progress) progress(last - first);
    }
  }

  void run_range(Entry entry, const Choice& choice, const Frame& frame, int first, int last) {
    compilation_.run[std::size_t(entry)](choice, data_.planes->data(), frame, data_.lights.data(), data_.lists.data(), data_.tables.data(),
                                         data_.out->data(), first, last);
  }

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

const Culling& culling() {
  static const Culling& widest = [] {
    const Culling* found = nullptr;
    for (const Compilation& c : compilations())
      if (c.runs_here) found = c.culling;
    return std::ref(*found);
  }();
  return widest;
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
