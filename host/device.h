// A device that shades: an OpenCL device or the C++ twin, behind one face.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/planes.h"
#include "host/frame.h"
#include "kernels/entries.h"

namespace relume {

/// How a device may compute: as written, or with what its compiler makes of leave to contract, reorder and approximate (docs/portability.md has the
/// errors). NaN and infinities keep their meaning.
enum class Precision { exact, relaxed };

struct DeviceInfo {
  std::string name;      ///< "pthread-skylake-avx512-AMD EPYC", "twin"
  std::string platform;  ///< "Portable Computing Language"
  std::string vendor, version, driver;
  bool is_cpu = false, is_gpu = false;
  int lanes = 1;                   ///< RELUME_LANES its kernels are built with
  bool correctly_rounded = false;  ///< divide and square root round correctly: results equal the twin's bit for bit
  Precision precision = Precision::exact;
  std::uint64_t memory = 0;          ///< bytes
  std::uint64_t max_allocation = 0;  ///< bytes in one buffer
  int index = -1;                    ///< position in list_devices()
};

/// What a band is shaded from and into; the memory stays the caller's and must outlive the Band.
struct BandData {
  const Planes* planes;
  std::span<const LightRecord> lights;  ///< sorted by type
  std::span<const int> lists;           ///< LightLists::numbers(), where Frame::lists says so
  std::span<const float> tables;
  Planes* out;
};

#define RELUME_ENTRY_NAME(name) name,
/// The kernels that there are (kernels/entries.h).
enum class Entry { RELUME_ENTRIES(RELUME_ENTRY_NAME) };
#undef RELUME_ENTRY_NAME

/// About what a kernel of environments costs a pixel, in lights: some dozens of samples, each with its look-ups as much as a few.
constexpr std::int64_t environment_work = 512;

/// Called between slices of work with the pixels done since the last call; may throw to stop.
using Progress = std::function<void(std::int64_t pixels)>;

/// A band bound to a device: its memory is there, programs run over it.
class Band {
 public:
  virtual ~Band() = default;
  /// Shades the pixels whose program plane holds frame.program, with the lobes of `choice`.
  virtual void shade(const Choice& choice, const Frame& frame, const Progress& progress) = 0;
  /// Runs another kernel over all pixels of the frame: tabulated cosines (kernels/evaluate.h, kernels/terms.h), directions (kernels/directions.h).
  virtual void run(Entry entry, const Choice& choice, const Frame& frame) = 0;
  /// Adds the light of frame.environment to what the output holds, by one of the kernels named environment_*.
  virtual void add_environment(Entry entry, const Choice& choice, const Frame& frame, const Progress& progress) = 0;
  /// Makes the results visible in BandData::out.
  virtual void finish() = 0;
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const = 0;
  virtual std::unique_ptr<Band> bind(const BandData& data) = 0;
};

/// Every OpenCL device of every platform; platforms without devices are passed over. Never throws for want of OpenCL.
std::vector<DeviceInfo> list_devices();

/// `selector`: empty (the best there is: GPU, else CPU, else the twin), "cpu", "gpu", "twin", an index, or part of a platform's or device's name.
/// `lanes`: 0 for the device's own. The twin is always exact. Throws Error{device} that lists what was found.
std::unique_ptr<Device> open_device(const std::string& selector, int lanes = 0, Precision precision = Precision::exact);

}  // namespace relume
