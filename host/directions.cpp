// write_directions: the G-buffer band by band through the kernel `directions`.
#include "host/directions.h"

#include <algorithm>
#include <cstdio>

#include "gbuffer/contact_sheet.h"
#include "gbuffer/convention.h"
#include "gbuffer/error.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/printable.h"
#include "host/band_frame.h"
#include "host/binding.h"
#include "host/camera_choice.h"
#include "host/device_opening.h"
#include "host/light_records.h"
#include "host/rig_readers.h"
#include "kernels/directions_list.h"

namespace relume {
namespace {

constexpr int band_rows = 256;  // every codec's blocks fit

#define RELUME_TEXT(name) #name,
const std::vector<std::string> direction_names{RELUME_DIRECTIONS(RELUME_TEXT)}, cosine_names{RELUME_DIRECTION_COSINES(RELUME_TEXT)};
#undef RELUME_TEXT

std::vector<std::string> channels() {
  std::vector<std::string> all;
  for (const std::string& name : direction_names)
    for (const char* component : {".X", ".Y", ".Z"}) all.push_back(name + component);
  for (const std::string& name : cosine_names) all.push_back("cosine." + name);
  return all;
}

std::optional<glm::dvec3> point_of(const std::string& text) {
  glm::dvec3 p;
  char end = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &p.x, &p.y, &p.z, &end) != 3) return {};
  return p;
}

/// The light by its name, among those that come from one direction at each point.
Light chosen_light(const DirectionsJob& job, const Rig& rig) {
  std::vector<Light> lights;
  std::string names;
  for (const Light& light : rig.lights) {
    if (int(light.type) >= LIGHT_COUNT) continue;
    lights.push_back(light);
    names += (names.empty() ? "" : ", ") + printable(light.name);
  }
  const auto named = [&](const Light& light) { return job.light.empty() ? lights.size() == 1 : light.name == job.light; };
  const auto found = std::find_if(lights.begin(), lights.end(), named);
  if (found != lights.end()) return *found;
  if (const std::optional<glm::dvec3> place = point_of(job.light)) {
    Light light;
    light.position = *place;
    light.intensity = glm::dvec3(1);
    light.name = job.light;
    if (!beyond_single(light).empty()) throw Error(ErrorKind::input, "--light " + printable(job.light) + ": is beyond single precision");
    return light;
  }
  throw Error(ErrorKind::input, "--light " + (job.light.empty() ? std::string("is needed") : printable(job.light) + ": no such light") + " (has: " +
                                    (names.empty() ? "no light that comes from a direction" : names) + "; or X,Y,Z, a point in the world)");
}

/// Whole pictures of the layers, smaller where the frame is large.
class Sheet {
 public:
  explicit Sheet(const Window& frame) : frame_(frame), step_(view_step(frame)) {
    for (const std::string& name : direction_names) views_.push_back({name, name + " (rgb = xyz)", blank()});
    for (const std::string& name : cosine_names) views_.push_back({name, name + " (0 dark .. 1, below 0 orange)", blank()});
  }

  void add(const Window& band, const Planes& planes) {
    for (int y = band.min_y; y < band.max_y; ++y)
      for (int x = band.min_x; x < band.max_x; ++x)
        if ((y - frame_.min_y) % step_ == 0 && (x - frame_.min_x) % step_ == 0) paint(band, planes, x, y);
  }

  const std::vector<View>& views() const { return views_; }

 private:
  CodedPicture blank() const {
    const int width = (frame_.width() + step_ - 1) / step_, height = (frame_.height() + step_ - 1) / step_;
    return {width, height, 3, std::vector<unsigned char>(std::size_t(width) * std::size_t(height) * 3)};
  }

  void paint(const Window& band, const Planes& planes, int x, int y) {
    const std::size_t i = std::size_t(y - band.min_y) * std::size_t(band.width()) + std::size_t(x - band.min_x);
    const std::size_t to =
        (std::size_t((y - frame_.min_y) / step_) * std::size_t(views_[0].picture.width) + std::size_t((x - frame_.min_x) / step_)) * 3;
    const bool shown = planes.plane(0)[i] != 0 || planes.plane(1)[i] != 0 || planes.plane(2)[i] != 0;  // n is a unit vector there
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const int first = int(k < direction_names.size() ? 3 * k : 2 * direction_names.size() + k);
      const RgbCode code = !shown ? no_surface_colour
                           : k < direction_names.size()
                               ? direction_colour(planes.plane(first)[i], planes.plane(first + 1)[i], planes.plane(first + 2)[i])
                               : cosine_colour(planes.plane(first)[i]);
      std::copy(code.begin(), code.end(), views_[k].picture.codes.begin() + std::ptrdiff_t(to));
    }
  }

  Window frame_;
  int step_;
  std::vector<View> views_;
};

/// One light's directions for band after band.
class DirectionBands {
 public:
  DirectionBands(Device& device, const Light& light, const std::string& file, Reading& reading)
      : device_(device), reading_(reading), lights_(light_records({light})) {
    Material material;  // directions ask nothing of it
    material.diffuse = "lambert";
    material.specular = "none";
    material.parameters["albedo"] = std::vector<double>{1, 1, 1};
    binding_.emplace(
        material, std::nullopt, file, [](const std::string&) -> RoleLayer { return {}; }, reading_);
  }

  int spare_planes() const { return binding_->spare_planes(); }

  Planes of(GBuffer& gbuffer) const {
    Planes out(std::size_t(gbuffer.samples()), int(channels().size()));
    out.add(int(channels().size()));
    Frame frame = band_frame(gbuffer, reading_, out);
    binding_->bind(gbuffer, *reading_.camera, frame);
    std::copy(lights_.begin.begin(), lights_.begin.end(), frame.light_begin);
    const auto band = device_.bind({&gbuffer.planes, lights_.records, {}, binding_->tables(), &out});
    band->run(Entry::directions, binding_->programs().front(), frame);
    band->finish();
    return out;
  }

 private:
  Device& device_;
  Reading& reading_;
  LightRecords lights_;
  std::optional<Binding> binding_;
};

}  // namespace

DirectionsSummary write_directions(const DirectionsJob& job) {
  const ExrFile file(job.gbuffer);
  std::vector<Rig> rigs = read_rigs(job.rigs, job.rig_options, convention_of(file, job.reading).name);
  Reading reading = understand_with_rigs(file, job.reading, rigs);
  const Light light = chosen_light(job, merge(std::move(rigs)));
  DirectionsSummary summary{{}, light.name, {}};
  for (const std::string& note : reading.notes)
    if (note.starts_with("warning")) summary.notes.push_back(note);  // the others are about lobes
  DeviceOpening opening(job.device);
  const std::unique_ptr<Device> device = opening.tested({{DIFFUSE_lambert, SPECULAR_none, 0, 0, 0}}, summary.notes);
  summary.device = device->info().name;
  const DirectionBands bands(*device, light, job.gbuffer.string(), reading);
  const Window& window = reading.data_window;
  ExrWriter writer(job.output, job.format, file.parts()[std::size_t(reading.part)].header, window, reading.display_window, channels(),
                   {{"relume:gbuffer", job.gbuffer.filename().string()}, {"relume:light", light.name}});
  Sheet sheet(window);
  for (int top = window.min_y; top < window.max_y; top += band_rows) {
    const Window band{window.min_x, top, window.max_x, std::min(top + band_rows, window.max_y)};
    GBuffer gbuffer = read_gbuffer(file, reading, band, {}, bands.spare_planes());
    const Planes out = bands.of(gbuffer);
    std::vector<Source> sources;
    for (std::size_t c = 0; c < channels().size(); ++c)
      sources.push_back({channels()[c], out.plane(int(c)), sizeof(float), sizeof(float) * std::size_t(band.width())});
    writer.write_rows(band.height(), sources);
    sheet.add(band, out);
  }
  if (job.png) write_png(*job.png, contact_sheet(sheet.views()), job.format.overwrite);
  writer.commit();
  return summary;
}

}  // namespace relume
