// relume bake: a mesh and a camera to a G-buffer.
#include "bake/bake.h"

#include <cstdio>
#include <glm/geometric.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bake/read_mesh.h"
#include "cli/bake_arguments.h"
#include "cli/commands.h"
#include "cli/progress.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

struct BakeCommand {
  BakeArguments arguments;
  std::string mesh, output, compression = "zip";
  bool half = false, overwrite = false, quiet = false, json = false;
};

void print(const BakeCommand& c, const BakeJob& job, const BakeSummary& s, const std::vector<std::string>& notes) {
  if (c.json) {
    const nlohmann::ordered_json summary{{"width", job.width},
                                         {"height", job.height},
                                         {"surface_pixels", s.surface_pixels},
                                         {"triangles", s.triangles},
                                         {"vertices", s.vertices},
                                         {"camera", job.camera.source},
                                         {"notes", notes}};
    std::cout << summary.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  } else if (!c.quiet) {
    for (const std::string& note : notes) std::cerr << "note: " << printable_sentence(note) << "\n";
    std::fprintf(stderr, "%dx%d, %lld surface pixels of %lld triangles, camera: %s\n", job.width, job.height,
                 static_cast<long long>(s.surface_pixels), static_cast<long long>(s.triangles), printable_sentence(job.camera.source).c_str());
  }
}

int bake_mesh(const BakeCommand& c) {
  c.arguments.check();
  Mesh mesh = read_mesh(c.mesh, c.arguments.mesh_options());
  std::vector<std::string> notes = mesh.notes;
  const MeshView view = c.arguments.view_of(mesh, c.mesh, notes);
  const BakeJob job{c.output,
                    view.camera,
                    view.width,
                    view.height,
                    {c.half ? SampleType::half_float : SampleType::float32, c.compression, c.overwrite},
                    std::filesystem::path(c.mesh).filename().string()};
  BakeSummary summary;
  {
    ProgressBar bar(!c.quiet && !c.json);
    summary = bake(std::move(mesh), job, [&](double share) { bar.show("bake", share); });
  }
  if (summary.surface_pixels == 0) notes.emplace_back("warning: the camera sees nothing of the mesh: every pixel is empty");
  print(c, job, summary, notes);
  return 0;
}

}  // namespace

void add_bake(CLI::App& command, Action& action) {
  const auto c = std::make_shared<BakeCommand>();
  command.add_option("mesh", c->mesh, "OBJ, PLY, STL, glTF or GLB")->required();
  command.add_option("-o,--output", c->output, "the G-buffer, OpenEXR")->required();
  c->arguments.add_to(command);
  const char* out = "Output";
  command.add_flag("--half", c->half, "normals and colours in 16 bits; positions stay 32-bit")->group(out);
  command.add_option("--compression", c->compression, "EXR codec")->check(CLI::IsMember(compression_names()))->capture_default_str()->group(out);
  command.add_flag("--overwrite", c->overwrite, "replace an existing output")->group(out);
  command.add_flag("--quiet", c->quiet, "no progress bar, notes or summary")->group(out);
  command.add_flag("--json", c->json, "a summary for programs on stdout")->group(out);
  command.footer(
      "Examples:\n"
      "  relume bake teapot.obj -o teapot.exr                                            seen from where all of it is in the picture\n"
      "  relume bake scene.glb --camera rig.json --size 1920x1080 -o gbuffer.exr         from a rig's camera\n"
      "  relume bake scene.glb --camera render.exr --world-up z -o gbuffer.exr           as Blender saw it, in its own world\n"
      "  relume bake head.ply --eye 0,0,5 --target 0,0,0 --fov 30 -o head.exr            from a place");
  command.callback([c, &action] { action = [c] { return bake_mesh(*c); }; });
}

}  // namespace relume
