// relight(): understand the file, bind materials, shade band by band, write.
#include "host/relight.h"

#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>

#include "gbuffer/convention.h"
#include "gbuffer/error.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/watched.h"
#include "host/band_shading.h"
#include "host/bands.h"
#include "host/binding.h"
#include "host/camera_choice.h"
#include "host/device.h"
#include "host/device_opening.h"
#include "host/environment_error.h"
#include "host/frame_output.h"
#include "host/light_links.h"
#include "host/material_objects.h"
#include "host/mixed_pixels.h"
#include "host/output_layout.h"
#include "host/stopwatch.h"

namespace relume {
namespace {

OutputLayout layout_of(const RelightJob& job, const LightLinks& lights) {
  OutputLayout layout;
  if (job.diffuse_layer) layout.diffuse = layout.add_colour("diffuse");
  if (job.specular_layer) layout.specular = layout.add_colour("specular");
  if (job.ambient_layer || job.light_layers) layout.ambient = layout.add_colour("ambient");
  if (job.light_layers)
    for (std::size_t k = 0; k < lights.lights().size(); ++k) {
      const int first = layout.add_colour("light." + lights.lights()[k].name);
      if (k == 0) layout.lights = first;
    }
  return layout;
}

constexpr std::int64_t driver_bytes = std::int64_t(512) << 20;  // for a driver that is loaded, or compiles, while OpenEXR decodes

struct BandInWork {
  GBuffer gbuffer;
  Planes out;
};

/// One relight in progress: what the stages share.
class Relight {
 public:
  Relight(const RelightJob& job, const Observer& observer) : job_(job), observer_(observer), file_(job.gbuffer) {}

  RelightSummary run() {
    check_job();
    understand_all();
    open();
    shade_and_write();
    const double shading = watch_.seconds("shade");
    summary_.pixel_lights_per_second = shading > 0 ? double(summary_.surface_pixels) * summary_.directions / shading : 0;
    summary_.seconds = watch_.laps();
    return std::move(summary_);
  }

 private:
  void check_job() const;
  void understand_all();
  void bind_materials_and_lights();
  void open();
  void shade_and_write();
  std::vector<std::pair<std::string, std::string>> metadata() const;
  bool ambient_is_a_share() const;
  glm::dvec3 mean_irradiance();
  void light_mesh();
  void shade_band(BandInWork& band);
  void run_bands(FrameOutput& output);
  Bands bands(const Window& window) const;
  GBuffer read_band(const Window& band);

  void note(const std::string& text) { summary_.notes.push_back(text); }
  void progress(const std::string& stage, double share) const {
    beat();
    if (observer_.progress) observer_.progress(stage, share);
  }

  const RelightJob& job_;
  const Observer& observer_;
  RelightSummary summary_;
  Stopwatch watch_, shade_watch_;
  ExrFile file_;
  Reading reading_;
  Rig rig_;
  std::optional<LightLinks> lights_;
  std::optional<Binding> binding_;
  std::vector<std::string> roles_;
  OutputLayout layout_;
  std::optional<DeviceOpening> opening_;
  std::unique_ptr<Device> device_;
  std::optional<BandShading> shading_;
  std::optional<MeshRadiance> mesh_;  ///< where not pixels are lit but what they show parts of
  Window window_;
  MixedPixels mixed_pixels_;
  EnvironmentError environment_error_;
};

/// What can be refused before any work.
void Relight::check_job() const {
  if (!(job_.error >= 0 && job_.error < 1)) throw Error(ErrorKind::input, "error: is not a share, at least 0 and below 1");
  if (job_.png && !job_.format.overwrite && std::filesystem::exists(*job_.png))
    throw Error(ErrorKind::output, job_.png->string() + ": exists (--overwrite replaces it)");
}

void Relight::understand_all() {
  progress("read", 0);
  std::vector<Rig> rigs = read_rigs(job_.rigs, job_.rig_options, convention_of(file_, job_.reading).name);
  file_.leave_room(driver_bytes);
  opening_.emplace(job_.device, job_.precision);
  reading_ = understand_with_rigs(file_, job_.reading, rigs);
  rig_ = merge(std::move(rigs));
  if (!job_.mend_edges) reading_.filtered = reading_.position_premultiplied = false;
  bind_materials_and_lights();
  summary_.convention = reading_.convention;
  summary_.lights = int(lights_->lights().size());
  summary_.directions = int(lights_->records().size()) + int(lights_->environments().size()) * directions_of(job_.environments);
  summary_.programs = binding_->descriptions();
  for (const std::string& what : reading_.made) note("made: " + what);
  for (const std::vector<std::string>& notes : {rig_.notes, reading_.notes, binding_->notes(), lights_->notes()})
    for (const std::string& text : notes)
      if (std::find(summary_.notes.begin(), summary_.notes.end(), text) == summary_.notes.end()) note(text);
  window_ = reading_.data_window;
  if (job_.crop) {
    window_ = intersection(window_, *job_.crop);
    if (window_.empty()) throw Error(ErrorKind::input, job_.gbuffer.string() + ": --crop lies outside the data window");
  }
  summary_.window = window_;
  watch_.lap("understand");
}

void Relight::bind_materials_and_lights() {
  std::optional<MaterialFile> materials;
  if (job_.materials) {
    materials = read_materials(*job_.materials);
    find_objects(*materials, file_, reading_, job_.materials->string());
  }
  binding_.emplace(
      job_.material, materials, job_.gbuffer.string(), [this](const std::string& layer) { return find_layer(file_, reading_, layer); }, reading_);
  lights_.emplace(rig_.lights, file_, reading_, binding_->objects(), job_.environments);
  roles_ = binding_->roles();
  for (const std::string& role : lights_->roles())
    if (std::find(roles_.begin(), roles_.end(), role) == roles_.end()) roles_.push_back(role);
  if (reading_.roles.contains("coverage")) roles_.push_back("coverage");
}

void Relight::open() {
  progress("compile", 0);
  device_ = opening_->tested(binding_->programs(), summary_.notes, programs_for(lights_->environments(), job_.environments));
  summary_.device = device_->info().name;
  if (device_->info().precision == Precision::relaxed)
    note("relaxed precision: the picture differs from the exact one in rounding (docs/portability.md)");
  layout_ = layout_of(job_, *lights_);
  shading_.emplace(*device_, *binding_, *lights_, layout_, reading_, job_.error, job_.environments);
  if (job_.interpolation != Interpolation::phong) mesh_.emplace(file_, reading_, job_.interpolation, layout_, job_.memory);
  watch_.lap("compile");
}

/// Planes in and out within the memory given, and each buffer within what the device takes.
Bands Relight::bands(const Window& window) const {
  std::int64_t in = 3 + 3 + 3 + 1 + 3 + shading_->spare_planes();  // and what is read beside the planes: depth, ids, materials
  for (const std::string& role : roles_) in += is_made(reading_, role) ? 3 : std::int64_t(reading_.roles.at(role).channels.size());
  const std::int64_t out = shading_->planes(), samples = reading_.filtered ? Mixtures::most_surfaces : 1;
  const std::int64_t largest = std::max(in, out), row = window.width() * std::int64_t(sizeof(float)) * samples;
  // Offsets into the planes are 32-bit ints.
  const std::int64_t by_index = ((std::int64_t(1) << 31) / largest - std::int64_t(Planes::granule + Planes::shift)) / (window.width() * samples);
  const std::int64_t by_device = std::int64_t(device_->info().max_allocation / std::uint64_t(largest * row));
  // Bands whose pixels are told by their neighbours read some rows of the next as well: larger ones read fewer twice.
  const bool has_margins = reading_.filtered || reading_.position_premultiplied || is_made(reading_, "normal");
  const std::int64_t good_pixels = has_margins ? 1 << 20 : 1 << 18;
  const Part& part = file_.parts()[std::size_t(reading_.part)];
  return bands_of(
      window, {job_.memory, (in + out) * row, std::min(by_device, by_index), good_pixels, part.data_window.min_y, file_.rows_in_block(part.index)},
      job_.gbuffer.string());
}

GBuffer Relight::read_band(const Window& band) {
  const Mixtures mixtures = find_mixtures(file_, reading_, band, roles_);
  mixed_pixels_.add(mixtures);
  return read_gbuffer(file_, reading_, band, roles_, shading_->spare_planes(), mixtures);
}

bool Relight::ambient_is_a_share() const {
  return std::any_of(lights_->groups().begin(), lights_->groups().end(), [](const LightGroup& g) { return g.ambient_fraction != 0; });
}

/// Of the whole frame: a crop looks the same.
glm::dvec3 Relight::mean_irradiance() {
  BandShading::Irradiance irradiance;
  const Window& whole = reading_.data_window;
  for (const Window& band : bands(whole).windows) {
    GBuffer gbuffer = read_gbuffer(file_, reading_, band, roles_, shading_->spare_planes());
    shading_->add_irradiance(gbuffer, irradiance, [&](std::int64_t) { progress("ambient", double(band.min_y - whole.min_y) / whole.height()); });
  }
  return irradiance.mean();
}

std::vector<std::pair<std::string, std::string>> Relight::metadata() const {
  std::vector<std::pair<std::string, std::string>> texts{
      {"relume:gbuffer", job_.gbuffer.filename().string()}, {"relume:device", summary_.device}, {"relume:version", RELUME_VERSION}};
  std::string made;
  for (const std::string& what : reading_.made) made += (made.empty() ? "" : "; ") + what;
  if (!made.empty()) texts.emplace_back("relume:made", made);
  return texts;
}

/// Vertices or facets, all at once: any pixel may show any of them.
void Relight::light_mesh() {
  shade_watch_.start();
  for (const Window& band : bands(mesh_->reading().data_window).windows) {
    GBuffer samples = read_gbuffer(file_, mesh_->reading(), band, roles_, shading_->spare_planes());
    Planes lit(std::size_t(samples.samples()), shading_->planes());
    lit.add(shading_->planes());
    shading_->shade(samples, lit, shade_watch_, [this](std::int64_t) { progress("shade", 0); });
    mesh_->take(band, lit);
  }
}

void Relight::shade_band(BandInWork& band) {
  GBuffer& gbuffer = band.gbuffer;
  summary_.surface_pixels += gbuffer.surface_pixels;
  summary_.bad_pixels += gbuffer.bad_pixels;
  ++summary_.bands;
  band.out = Planes(std::size_t(gbuffer.samples()), shading_->planes());
  band.out.add(shading_->planes());
  const double all = double(window_.pixels()) * shading_->rounds();
  double done = double(gbuffer.window.min_y - window_.min_y) * window_.width() * shading_->rounds();
  const auto shaded = [&](std::int64_t pixels) { progress("shade", std::min((done += double(pixels)) / all, 1.0)); };
  if (mesh_)
    mesh_->interpolate(gbuffer, band.out);
  else
    shading_->shade(gbuffer, band.out, shade_watch_, shaded);
  if (const int plane = shading_->error_plane(); plane >= 0 && !mesh_) environment_error_.add(gbuffer, band.out, plane);
  write_alpha(gbuffer, reading_, band.out);
  fold_surfaces(gbuffer, band.out);
  shade_watch_.lap("shade");
}

/// A band is decoded while the one before is shaded and the one before that encoded. Each stage takes bands in order, one at a time, on all cores.
void Relight::run_bands(FrameOutput& output) {
  using Work = std::shared_ptr<BandInWork>;
  const Bands all = bands(window_);
  file_.leave_room(all.bytes + driver_bytes);
  auto next = all.windows.begin();
  Stopwatch read_watch, write_watch;
  const auto read = [&](tbb::flow_control& flow) -> Work {
    if (next == all.windows.end()) return flow.stop(), nullptr;
    read_watch.start();
    const Work band = std::make_shared<BandInWork>(BandInWork{read_band(*next++), Planes(0, 0)});
    read_watch.lap("read");
    return band;
  };
  const auto shade = [&](const Work& band) {
    shade_watch_.start();
    shade_band(*band);
    return band;
  };
  const auto write = [&](const Work& band) {
    write_watch.start();
    output.write(band->gbuffer.window, band->out);
    write_watch.lap("write");
  };
  constexpr auto in_order = tbb::filter_mode::serial_in_order;
  tbb::parallel_pipeline(std::size_t(all.in_flight), tbb::make_filter<void, Work>(in_order, read) & tbb::make_filter<Work, Work>(in_order, shade) &
                                                         tbb::make_filter<Work, void>(in_order, write));
  for (const Stopwatch* watch : {&read_watch, &shade_watch_, &write_watch}) watch_.add(*watch);
  watch_.start();
}

void Relight::shade_and_write() {
  shading_->set_ambient(ambient_is_a_share() ? mean_irradiance() : glm::dvec3(0));
  const Part& part = file_.parts()[std::size_t(reading_.part)];
  FrameOutput output(job_, layout_, part.header, window_, reading_.display_window, metadata());
  watch_.lap("prepare");
  if (mesh_) light_mesh();
  run_bands(output);
  if (summary_.bad_pixels)
    note("warning: " + std::to_string(summary_.bad_pixels) + " pixels have a NaN or infinite position or normal: written as showing no surface");
  if (job_.error > 0) note(shading_->tree_sentence());
  if (const std::string sentence = mixed_pixels_.sentence(summary_.surface_pixels); !sentence.empty()) note(sentence);
  if (shading_->error_plane() >= 0 && !mesh_) note(environment_error_.sentence(job_.environments));
  progress("write", 1);
  output.commit();
  watch_.lap("write");
}

}  // namespace

RelightSummary relight(const RelightJob& job, const Observer& observer) { return Relight(job, observer).run(); }

}  // namespace relume
