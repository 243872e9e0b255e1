// libFuzzer's target: bytes as an OpenEXR file, through header scan, decoding, what the data are asked, the making of a G-buffer, ids, and diagnosis.
#include <ImfThreading.h>
#include <sys/mman.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "gbuffer/doctor.h"
#include "gbuffer/error.h"
#include "gbuffer/false_colour.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/object_ids.h"

namespace {

using namespace relume;

// Small enough that an execution takes milliseconds; the limits themselves are what refuses the rest.
constexpr ReadLimits limits{.max_decoded_bytes = 1 << 20, .max_side = 4096, .max_parts = 16, .max_channels = 64};
constexpr int band_rows = 32;  // several bands of a file that is taller

/// A file in memory with a path, since that is what ExrFile opens.
class FileInMemory {
 public:
  FileInMemory() : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {}
  const std::string& with(const std::uint8_t* data, std::size_t size) const {
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, data, size, 0) != ssize_t(size)) std::abort();
    return path_;
  }

 private:
  int descriptor_;
  std::string path_;
};

[[noreturn]] void defect(const char* what, const std::string& message) {
  std::fprintf(stderr, "%s: %s\n", what, message.c_str());
  std::abort();
}

/// What a refusal must be: input's or memory's fault, one printable line, the file first.
void check_refusal(const Error& error, const std::string& path) {
  const std::string line = error.what();
  if (error.kind != ErrorKind::input && error.kind != ErrorKind::memory) defect("not the file's fault", line);
  if (!line.starts_with(path + ": ")) defect("does not name the file first", line);
  for (const char c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) defect("not one printable line", line);
}

template <class Work>
void refusing(const std::string& path, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    check_refusal(error, path);
  }
}

/// Every channel of full resolution, band by band, as a number and as it is stored.
void decode(const ExrFile& file) {
  for (const Part& part : file.parts()) {
    const Window& all = part.data_window;
    for (int y = all.min_y; y < all.max_y; y += band_rows) {
      const Window band{all.min_x, y, all.max_x, std::min(y + band_rows, all.max_y)};
      std::vector<float> samples(std::size_t(band.pixels()) * part.channels.size());
      std::vector<Destination> to;
      for (const Channel& channel : part.channels)
        to.push_back({channel.name, SampleType::float32, samples.data() + to.size() * std::size_t(band.pixels()), sizeof(float),
                      std::size_t(band.width()) * sizeof(float)});
      file.read(part.index, band, to);
    }
  }
}

/// Every object counted and called by its name, and found again by it.
void use_ids(ObjectIds& ids, const GBuffer& gbuffer, const std::string& path) {
  ObjectCounts counts;
  ids.count(gbuffer, counts);
  for (const auto& [id, count] : counts) ids.called(id);
  const std::string known = !ids.is_cryptomatte() ? "1" : ids.manifest().empty() ? "ball" : ids.manifest().ids.begin()->first;
  const std::vector<std::uint32_t> meant = ids.ids_of({known}, path);
  ids.most_covering(gbuffer);
  ids.shares(gbuffer, {meant.begin(), meant.end()});
  ids.ids_of({"0x3f000000", "no such object"}, path);  // most refuse it
}

/// What each band holds for the lobes, mixed pixels taken apart; then the ids.
void read_bands(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles, ObjectIds* ids) {
  const Window& all = reading.data_window;
  for (int y = all.min_y; y < all.max_y; y += band_rows) {
    const Window band{all.min_x, y, all.max_x, std::min(y + band_rows, all.max_y)};
    const GBuffer gbuffer = read_gbuffer(file, reading, band, roles, 0, find_mixtures(file, reading, band, roles));
    if (ids) use_ids(*ids, gbuffer, file.path());
  }
}

/// As `shade` does: the reading, then bands with every role that was found.
void read_as(const ExrFile& file, const ReadingOptions& options) {
  const Reading reading = understand(file, options);
  std::vector<std::string> roles;
  for (const auto& [role, layer] : reading.roles)
    if (role != "position" && role != "normal" && role != "base_normal" && role != "depth" && role != "tangent") roles.push_back(role);
  if (is_made(reading, "albedo")) roles.push_back("albedo");
  read_bands(file, reading, roles, nullptr);
}

/// As `inspect --objects` does: every Cryptomatte, or the layer of ids.
void read_objects(const ExrFile& file, const ReadingOptions& options) {
  const Reading reading = understand(file, options);
  std::vector<std::string> names{""};
  for (const Cryptomatte& cryptomatte : cryptomattes_of(file, reading)) names.push_back(cryptomatte.name);
  for (const std::string& name : names)
    refusing(file.path(), [&] {
      Reading with_ids = reading;
      ObjectIds ids(file, with_ids, name, false);
      read_bands(file, with_ids, ids.roles(), &ids);
    });
}

/// As `doctor --png` does, but that a file which cannot all be decoded is refused here.
void examine(const ExrFile& file, const ReadingOptions& options) {
  const std::vector<glm::dvec3> lights{{1, 2, 3}};
  const Diagnosis diagnosis = diagnose(file, options, lights);
  const std::vector<View> views = false_colour_views(file, diagnosis.reading);
  if (!views.empty()) marked_view(views.front(), diagnosis.reading.data_window, mark_findings(file, diagnosis, lights), std::vector<bool>(256));
}

/// One way of asking for each file, by its size: all for each would cost the speed. Most say that positions are in camera space: recovering a camera
/// from others takes longer than all else.
ReadingOptions options_for(std::size_t size) {
  const std::size_t way = size % 8;
  ReadingOptions options;
  if (way == 0) options.recover_camera = size % 16 == 0;
  if (way > 1) options.position_space = Space::camera;
  if (way == 1 || way == 2) options.camera = Camera{};
  if (way == 2) options.camera->lens = Lens{12, 12, 6, 6};
  if (way == 3) options.normal_encoding = NormalEncoding::as_unsigned;
  if (way == 4) options.normal_space = Space::camera;
  if (way == 5) options.premultiplied = true;
  if (way == 6) options.depth_kind = DepthKind::distance;
  return options;
}

/// Likewise one use of it.
void use(const ExrFile& file, std::size_t size) {
  const ReadingOptions options = options_for(size);
  const std::size_t way = size / 8 % 4;
  if (way == 0) examine(file, options);
  if (way == 1) read_objects(file, options);
  if (way > 1) read_as(file, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const FileInMemory memory;
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);  // a crash must come again from the same bytes
  const std::string& path = memory.with(data, size);
  refusing(path, [&] {
    const ExrFile file(path, limits);
    Imf::setGlobalThreadCount(0);
    refusing(path, [&] { decode(file); });
    refusing(path, [&] { use(file, size); });
  });
  return 0;
}
