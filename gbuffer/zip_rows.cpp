// read_zip_rows: workers take block after block; OpenEXR reads a block's bytes from the file and checks its header.
#include "gbuffer/zip_rows.h"

#include <ImfChannelList.h>
#include <ImfPartType.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <vector>

#include "gbuffer/half_floats.h"
#include "gbuffer/zip_block.h"

namespace relume {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are stored with their low byte first");

std::size_t bytes_of(SampleType type) { return type == SampleType::half_float ? 2 : 4; }

/// One channel on its way from a row of a block to where it is wanted.
struct Course {
  std::size_t offset;  ///< bytes into the row, of the first pixel asked for
  SampleType stored;
  Destination to;
};

struct Plan {
  std::vector<Course> courses;
  std::size_t row_bytes = 0;
};

Plan plan_of(const Part& part, const Window& window, std::span<const Destination> destinations) {
  Plan plan;
  for (const Channel& channel : part.channels) {
    const std::size_t bytes = bytes_of(channel.type);
    const auto wanted = std::find_if(destinations.begin(), destinations.end(), [&](const Destination& d) { return d.channel == channel.name; });
    if (wanted != destinations.end())
      plan.courses.push_back({plan.row_bytes + bytes * std::size_t(window.min_x - part.data_window.min_x), channel.type, *wanted});
    plan.row_bytes += bytes * std::size_t(part.data_window.width());
  }
  return plan;
}

/// Samples side by side to where they go, each in its place.
void scatter(const char* from, std::size_t bytes, std::size_t count, char* to, std::size_t step) {
  if (step == bytes) {
    std::memcpy(to, from, count * bytes);
  } else if (bytes == 4) {
    for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * step, from + 4 * i, 4);
  } else {
    for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * step, from + 2 * i, 2);
  }
}

/// The memory of one worker.
class Worker {
 public:
  Worker(const Imf::InputPart& input, const Part& part, const Window& window, int block_rows, const Plan& plan)
      : input_(input), part_(part), window_(window), block_rows_(block_rows), plan_(plan) {}

  /// The rows asked for of the block that begins with row `top`.
  void read_block(int top) {
    const int end = std::min(top + block_rows_, part_.data_window.max_y);
    packed_.resize(plan_.row_bytes * std::size_t(block_rows_));  // the most that OpenEXR reads
    int size = 0;
    input_.rawPixelDataToBuffer(top, packed_.data(), size);
    unpacker_.unpack({packed_.data(), std::size_t(size)}, plan_.row_bytes * std::size_t(end - top));
    for (int y = std::max(top, window_.min_y); y < std::min(end, window_.max_y); ++y)
      for (const Course& course : plan_.courses) send(course, plan_.row_bytes * std::size_t(y - top) + course.offset, y);
  }

 private:
  void send(const Course& course, std::size_t at, int y) {
    const std::size_t count = std::size_t(window_.width()), bytes = bytes_of(course.stored), step = course.to.x_stride;
    char* const to = static_cast<char*>(course.to.first) + std::size_t(y - window_.min_y) * course.to.y_stride;
    const bool in_place = course.stored == course.to.type && step == bytes;
    samples_.resize(4 * count);
    char* const samples = in_place ? to : samples_.data();
    unpacker_.take(at, count * bytes, samples);
    if (in_place) return;
    if (course.stored == course.to.type) return scatter(samples, bytes, count, to, step);
    floats_.resize(count);
    float* const floats = step == sizeof(float) ? reinterpret_cast<float*>(to) : floats_.data();
    if (course.stored == SampleType::half_float)
      floats_of(reinterpret_cast<const half*>(samples), floats, count);
    else
      std::copy_n(reinterpret_cast<const std::uint32_t*>(samples), count, floats);
    if (floats == floats_.data()) scatter(reinterpret_cast<const char*>(floats), sizeof(float), count, to, step);
  }

  const Imf::InputPart& input_;
  const Part& part_;
  const Window& window_;
  const int block_rows_;
  const Plan& plan_;
  ZipUnpacker unpacker_;
  std::vector<char> packed_, samples_;
  std::vector<float> floats_;
};

}  // namespace

bool reads_zip_rows(const Part& part, std::span<const Destination> destinations) {
  const Imf::Compression codec = part.header.compression();
  if (codec != Imf::ZIP_COMPRESSION && codec != Imf::ZIPS_COMPRESSION) return false;
  if (part.header.hasTileDescription() || (part.header.hasType() && part.header.type() != Imf::SCANLINEIMAGE)) return false;
  std::size_t channels = 0;
  for (auto i = part.header.channels().begin(); i != part.header.channels().end(); ++i) ++channels;
  if (channels != part.channels.size()) return false;  // the others are subsampled
  return std::all_of(destinations.begin(), destinations.end(), [&](const Destination& to) {
    const auto from = std::find_if(part.channels.begin(), part.channels.end(), [&](const Channel& c) { return c.name == to.channel; });
    return to.type == SampleType::float32 || to.type == from->type;
  });
}

void read_zip_rows(const Imf::InputPart& input, const Part& part, const Window& window, std::span<const Destination> destinations, int block_rows,
                   int threads) {
  const Plan plan = plan_of(part, window, destinations);
  const int first = (window.min_y - part.data_window.min_y) / block_rows, last = (window.max_y - 1 - part.data_window.min_y) / block_rows;
  std::atomic<int> next{first};
  const int workers = std::clamp(threads, 1, last - first + 1);
  tbb::parallel_for(
      tbb::blocked_range<int>(0, workers, 1),
      [&](const auto&) {
        Worker worker(input, part, window, block_rows, plan);
        try {
          for (int block; (block = next++) <= last;) worker.read_block(part.data_window.min_y + block * block_rows);
        } catch (...) {
          next = last + 1;  // the others need not go on
          throw;
        }
      },
      tbb::simple_partitioner());
}

}  // namespace relume
