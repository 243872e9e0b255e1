// relume directions: the lecture's n, v, l, R_v, R_l and h of every pixel for one light, and their cosines, as layers of an EXR.
#include "host/directions.h"

#include <iostream>

#include "cli/commands.h"
#include "cli/reading_arguments.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

struct DirectionsArguments {
  std::string gbuffer, output, light, png, device, compression = "zip";
  std::vector<std::string> rigs;
  bool half = false, overwrite = false, quiet = false;
  ReadingArguments reading;
};

int directions(const DirectionsArguments& a) {
  DirectionsJob job;
  job.gbuffer = a.gbuffer;
  job.output = a.output;
  job.rigs.assign(a.rigs.begin(), a.rigs.end());
  job.reading = a.reading.options();
  job.light = a.light;
  job.format = {a.half ? SampleType::half_float : SampleType::float32, a.compression, a.overwrite};
  if (!a.png.empty()) job.png = a.png;
  job.device = a.device;
  const DirectionsSummary summary = write_directions(job);
  if (a.quiet) return 0;
  for (const std::string& note : summary.notes) std::cerr << "note: " << printable_sentence(note) << "\n";
  std::cerr << "directions for light " << printable(summary.light) << " on " << printable(summary.device) << "\n";
  return 0;
}

}  // namespace

void add_directions(CLI::App& command, Action& action) {
  const auto a = std::make_shared<DirectionsArguments>();
  command.add_option("gbuffer", a->gbuffer, "an OpenEXR file with normals and positions")->required();
  command.add_option("--lights,-l", a->rigs, "a rig: Relume's JSON, or glTF/GLB with KHR_lights_punctual");
  command.add_option("--light", a->light, "the light's name in the rig, or X,Y,Z: a point in the world, with no rig; default: the rig's only light");
  command.add_option("-o,--output", a->output, "OpenEXR with layers n, v, l, R_v, R_l, h (X Y Z) and cosine.n_l, n_v, l_v, n_h, v_h, R_v_l")
      ->required();
  command.add_option("--png", a->png, "all layers in false colours, side by side");
  command.add_flag("--half", a->half, "16-bit samples");
  command.add_option("--compression", a->compression, "EXR codec")->check(CLI::IsMember(compression_names()))->capture_default_str();
  command.add_flag("--overwrite", a->overwrite, "replace existing outputs");
  command.add_flag("--quiet", a->quiet, "no notes");
  command.add_option("--device", a->device, "as for shade; default: the best there is");
  a->reading.add_to(command);
  command.footer(
      "Directions are unit vectors in the world's space, away from the surface; 0 where no surface is shown. R_v is v mirrored at n, R_l is l, and h "
      "is "
      "half way between l and v.\n"
      "Example: relume directions shot.exr --lights rig.json --light key -o directions.exr --png directions.png");
  command.callback([a, &action] { action = [a] { return directions(*a); }; });
}

}  // namespace relume
