// relume shade: the main job.
#include <charconv>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/environment_arguments.h"
#include "cli/progress.h"
#include "cli/reading_arguments.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/relight.h"

namespace relume {
namespace {

struct ShadeArguments {
  std::string gbuffer, output, materials, png, layers, crop, diffuse = "auto", specular = "auto", edges = "mend", precision = "exact", device,
                                                             interpolation = "phong", compression = "zip", units, up, range, scale = "auto",
                                                             memory = "2G", error = "0";
  std::vector<std::string> rigs, set;
  EnvironmentArguments environments;
  double exposure = 0;
  bool half = false, full = false, overwrite = false, quiet = false, json = false;
  ReadingArguments reading;
};

/// "512M", "2G", "1000000" bytes.
std::int64_t bytes_of(const std::string& text) {
  std::size_t used = 0;
  double number = 0;
  try {
    number = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  const double scale = unit == "" ? 1 : unit == "K" ? 1 << 10 : unit == "M" ? 1 << 20 : unit == "G" ? 1 << 30 : 0;
  if (used == 0 || scale == 0 || !(number > 0) || number * scale > 9e18)
    throw Error(ErrorKind::input, "--memory " + text + ": is not a size (512M, 2G)");
  return std::int64_t(number * scale);
}

/// "100", "0.01"
double scale_of(const std::string& text) {
  double scale = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
  if (error != std::errc{} || end != text.data() + text.size() || !(scale > 0) || !(scale < 1e9))
    throw Error(ErrorKind::input, "--rig-scale " + text + ": is not auto or a number above 0 (100: metres in a world of centimetres)");
  return scale;
}

/// "0", "0.01"
double error_of(const std::string& text) {
  double share = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
  if (error != std::errc{} || end != text.data() + text.size() || !(share >= 0) || !(share < 1))
    throw Error(ErrorKind::input, "--error " + text + ": is not a share, at least 0 and below 1 (0: exact; 0.01: within 1%)");
  return share;
}

Window window_of(const std::string& text) {
  Window w;
  char end = 0;
  if (std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &w.min_x, &w.min_y, &w.max_x, &w.max_y, &end) != 4 || w.empty())
    throw Error(ErrorKind::input, "--crop " + text + ": is not X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1 (X1, Y1: one past the last)");
  return w;
}

void choose_layers(const std::string& text, RelightJob& job) {
  std::stringstream list(text);
  for (std::string name; std::getline(list, name, ',');) {
    if (name == "diffuse")
      job.diffuse_layer = true;
    else if (name == "specular")
      job.specular_layer = true;
    else if (name == "ambient")
      job.ambient_layer = true;
    else if (name == "lights")
      job.light_layers = true;
    else if (name != "total")
      throw Error(ErrorKind::input, "--layers: no layer \"" + name + "\" (has: total, diffuse, specular, ambient, lights)");
  }
}

RelightJob job_of(const ShadeArguments& a) {
  RelightJob job;
  job.gbuffer = a.gbuffer;
  job.output = a.output;
  job.rigs.assign(a.rigs.begin(), a.rigs.end());
  if (!a.units.empty())
    job.rig_options.units = a.units == "spec" ? RigOptions::Units::spec : a.units == "compat" ? RigOptions::Units::compat : RigOptions::Units::raw;
  if (!a.up.empty()) job.rig_options.up = a.up == "y" ? RigOptions::Up::y : RigOptions::Up::z;
  if (a.scale != "auto") job.rig_options.scale = scale_of(a.scale);
  if (!a.range.empty()) job.rig_options.obey_range = a.range == "obey";
  job.environments = a.environments.options();
  job.reading = a.reading.options();
  if (a.diffuse != "auto") job.material.diffuse = a.diffuse;
  if (a.specular != "auto") job.material.specular = a.specular;
  for (const std::string& assignment : a.set) set_parameter(job.material, assignment);
  check(job.material, "command line");
  if (!a.materials.empty()) job.materials = a.materials;
  choose_layers(a.layers, job);
  if (!a.crop.empty()) job.crop = window_of(a.crop);
  job.interpolation = a.interpolation == "gouraud" ? Interpolation::gouraud : a.interpolation == "flat" ? Interpolation::flat : Interpolation::phong;
  job.mend_edges = a.edges == "mend";
  job.format = {a.half ? SampleType::half_float : SampleType::float32, a.compression, a.overwrite};
  if (!a.png.empty()) job.png = a.png;
  job.exposure = a.exposure;
  job.error = error_of(a.error);
  job.device = a.device;
  job.precision = a.precision == "relaxed" ? Precision::relaxed : Precision::exact;
  job.memory = bytes_of(a.memory);
  return job;
}

nlohmann::ordered_json json_of(const RelightSummary& s) {
  nlohmann::ordered_json seconds;
  for (const auto& [stage, time] : s.seconds) seconds[stage] = time;
  return {{"device", s.device},
          {"convention", s.convention},
          {"width", s.window.width()},
          {"height", s.window.height()},
          {"surface_pixels", s.surface_pixels},
          {"bad_pixels", s.bad_pixels},
          {"lights", s.lights},
          {"directions", s.directions},
          {"bands", s.bands},
          {"programs", s.programs},
          {"seconds", seconds},
          {"pixel_lights_per_second", s.pixel_lights_per_second},
          {"notes", s.notes}};
}

int shade(const ShadeArguments& arguments) {
  const RelightJob job = job_of(arguments);
  RelightSummary summary;
  {
    ProgressBar bar(!arguments.quiet && !arguments.json);
    summary = relight(job, {[&](const std::string& stage, double share) { bar.show(stage, share); }});
  }
  if (arguments.json) {
    std::cout << json_of(summary).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  } else if (!arguments.quiet) {
    for (const std::string& note : summary.notes) std::cerr << "note: " << printable_sentence(note) << "\n";
    std::fprintf(stderr, "%dx%d, %d lights%s, %lld surface pixels on %s:", summary.window.width(), summary.window.height(), summary.lights,
                 summary.directions == summary.lights ? "" : (" in " + std::to_string(summary.directions) + " directions").c_str(),
                 static_cast<long long>(summary.surface_pixels), printable(summary.device).c_str());
    for (const auto& [stage, seconds] : summary.seconds) std::fprintf(stderr, " %s %.3f s", stage.c_str(), seconds);
    std::fprintf(stderr, "; %.1f million pixel*lights/s\n", summary.pixel_lights_per_second / 1e6);
  }
  return 0;
}

void add_rig_options(CLI::App& command, ShadeArguments& a) {
  const char* rig = "What a glTF rig does not say";
  command.add_option("--rig-units", a.units, "units of Blender's exporter")->check(CLI::IsMember({"spec", "compat", "raw"}))->group(rig);
  command.add_option("--rig-up", a.up, "the axis that points up in the rig")->check(CLI::IsMember({"y", "z"}))->group(rig);
  command.add_option("--rig-scale", a.scale, "units of the G-buffer in one of the rig's (100: metres to centimetres); auto: told by its camera")
      ->capture_default_str()
      ->group(rig);
  command.add_option("--rig-range", a.range, "what to do with lights' ranges")->check(CLI::IsMember({"obey", "ignore"}))->group(rig);
}

void add_output_options(CLI::App& command, ShadeArguments& a) {
  const char* out = "Output";
  const auto half = command.add_flag("--half", a.half, "16-bit samples")->group(out);
  command.add_flag("--float", a.full, "32-bit samples (default)")->excludes(half)->group(out);
  command.add_option("--compression", a.compression, "EXR codec")->check(CLI::IsMember(compression_names()))->capture_default_str()->group(out);
  command.add_option("--png", a.png, "a picture to look at as well (sRGB)")->group(out);
  command.add_option("--exposure", a.exposure, "stops, of the PNG")->group(out);
  command.add_flag("--overwrite", a.overwrite, "replace an existing output")->group(out);
  command.add_flag("--quiet", a.quiet, "no progress bar, notes or summary")->group(out);
  command.add_flag("--json", a.json, "a summary for programs on stdout")->group(out);
}

void add_device_options(CLI::App& command, ShadeArguments& a) {
  command.add_option("--device", a.device,
                     "cpu, gpu, twin (C++, no OpenCL), an index, or part of a platform's or device's name; default: the best there is");
  command
      .add_option(
          "--precision", a.precision,
          "exact: every device rounds alike; relaxed: what the driver's compiler makes faster, with an error of some 1e-5 (docs/portability.md)")
      ->check(CLI::IsMember({"exact", "relaxed"}))
      ->capture_default_str();
  command
      .add_option(
          "--error", a.error,
          "for speed under thousands of unranged point lights: the share of itself that a channel of a pixel may be off by (0.01: 1%); 0: exact")
      ->capture_default_str();
  command.add_option("--memory", a.memory, "for the planes of the bands in flight: decoded, shaded and encoded at the same time")
      ->capture_default_str();
}

}  // namespace

void add_shade(CLI::App& command, Action& action) {
  const auto a = std::make_shared<ShadeArguments>();
  command.add_option("gbuffer", a->gbuffer, "an OpenEXR file with normals and positions")->required();
  command
      .add_option("--lights,-l", a->rigs, "a rig: Relume's JSON, or glTF/GLB with KHR_lights_punctual; several are added up; - reads JSON from stdin")
      ->required();
  command.add_option("-o,--output", a->output, "the relit image, OpenEXR")->required();
  command.add_option("--diffuse", a->diffuse, "diffuse lobe (relume list brdfs), none, or auto: what the renderer that wrote the file computes");
  command.add_option("--specular", a->specular, "specular lobe, none, or auto");
  command.add_option("--set", a->set, "PARAM=VALUE: a constant for a parameter: roughness=0.4, albedo=0.5,0.4,0.3");
  command.add_option("--materials", a->materials, "a material file: lobes and constants for each object, by id or Cryptomatte name");
  command.add_option("--layers", a->layers, "what to write beside the total: diffuse,specular,ambient,lights; their sum is the total");
  command.add_option("--crop", a->crop, "X0,Y0,X1,Y1: shade this window only (X1, Y1: one past the last)");
  command
      .add_option("--edges", a->edges,
                  "pixels that mix surfaces: mend shades each surface by itself; as-stored shades the stored means, undivided by coverage")
      ->check(CLI::IsMember({"mend", "as-stored"}))
      ->capture_default_str();
  command
      .add_option(
          "--interpolation", a->interpolation,
          "what is lit, whatever the lobes: pixels with interpolated normals (phong), or of a G-buffer that relume bake made its vertices, with "
          "radiance interpolated (gouraud), or its facets (flat)")
      ->check(CLI::IsMember({"phong", "gouraud", "flat"}))
      ->capture_default_str();
  a->environments.add_to(command);
  a->reading.add_to(command);
  add_rig_options(command, *a);
  add_output_options(command, *a);
  add_device_options(command, *a);
  command.footer(
      "Examples:\n"
      "  relume shade shot.exr --lights rig.gltf -o relit.exr --png relit.png      a Blender, Mitsuba or pbrt G-buffer under a glTF rig\n"
      "  relume shade shot.exr -l rig.json --set roughness=0.4 -o relit.exr        a constant where the file has no roughness layer\n"
      "  relume shade shot.exr -l rig.json --materials m.json -o relit.exr         lobes and parameters by object id\n"
      "  relume shade shot.exr -l key.json -l fill.json --layers lights -o l.exr   each light in a layer of its own");
  command.callback([a, &action] { action = [a] { return shade(*a); }; });
}

}  // namespace relume
