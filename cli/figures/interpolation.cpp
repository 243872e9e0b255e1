// relume figure interpolation: Gouraud against Phong interpolation on a coarse mesh, or their difference against a sphere's density.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>

#include "bake/bake.h"
#include "bake/sphere_mesh.h"
#include "cli/bake_arguments.h"
#include "cli/figures/density.h"
#include "cli/figures/list.h"
#include "cli/figures/scan_line.h"
#include "gbuffer/error.h"
#include "gbuffer/picture.h"
#include "gbuffer/printable.h"
#include "gbuffer/temporary_file.h"
#include "gbuffer/whole_file.h"
#include "host/brdf_name.h"

namespace relume {
namespace {

constexpr const char* own_brdf = "lambert+phong";

struct Arguments {
  BakeArguments view;
  std::string input, output, csv, brdf = own_brdf, device;
  std::vector<std::string> rigs, set;
  double exposure = 0;
  int row = -1;
  bool density = false, overwrite = false, quiet = false;
};

/// Light over the viewer's right shoulder, for who gives none.
constexpr const char* own_rig = R"({"relume": 1, "lights": [{"type": "directional", "direction": [-1, -0.6, -2], "intensity": [3, 3, 3]},
                                    {"type": "ambient", "intensity": [0.05, 0.05, 0.05]}]})";

Lighting lighting_of(const Arguments& a, const std::filesystem::path& rig) {
  Lighting lighting{{a.rigs.begin(), a.rigs.end()}, material_named(a.brdf), a.device};
  if (a.rigs.empty()) {
    std::ofstream(rig) << own_rig;
    lighting.rigs.push_back(rig);
  }
  for (const std::string& assignment : a.set) set_parameter(lighting.material, assignment);
  check(lighting.material, "command line");
  return lighting;
}

std::string lobes_of(const Arguments& a, const Lighting& lighting) {
  std::string text = lighting.material.diffuse + " + " + lighting.material.specular;
  for (const std::string& assignment : a.set) text += ", " + assignment;
  return text;
}

/// The mesh, or the coarse sphere, baked to the file.
void bake_to(const std::filesystem::path& file, const Arguments& a, std::vector<std::string>& notes) {
  Mesh mesh = a.input.empty() ? sphere_mesh(3) : read_mesh(a.input, a.view.mesh_options());
  notes = mesh.notes;
  const MeshView seen = a.view.view_of(mesh, a.input, notes);
  BakeJob job;
  job.output = file;
  job.camera = seen.camera;
  job.width = seen.width;
  job.height = seen.height;
  job.format.overwrite = true;
  bake(std::move(mesh), job, [](double) {});
}

void write_image(const std::filesystem::path& file, const LitImage& image, double exposure) {
  Picture picture{image.width, image.height, 3, std::vector<float>(3 * image.rgb[0].size())};
  for (std::size_t i = 0; i < image.rgb[0].size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) picture.values[3 * i + c] = image.rgb[c][i];
  write_png(file, picture, exposure, true);
}

void draw_scan_line(const Arguments& a, const Lighting& lighting) {
  const bool baked = a.input.ends_with(".exr");
  const TemporaryFile made(".exr"), gouraud(".png"), phong(".png");
  const std::filesystem::path gbuffer = baked ? std::filesystem::path(a.input) : made.path();
  std::vector<std::string> notes;
  if (!baked) bake_to(gbuffer, a, notes);
  ScanLine line{lit(gbuffer, Interpolation::gouraud, lighting), lit(gbuffer, Interpolation::phong, lighting), facets_of(gbuffer), a.row,
                lobes_of(a, lighting)};
  if (line.row < 0) line.row = row_of_highlight(line.phong, line.facets);
  if (line.row >= line.phong.height)
    throw Error(ErrorKind::input,
                "--row " + std::to_string(line.row) + ": is not in the picture (0 to " + std::to_string(line.phong.height - 1) + ")");
  write_image(gouraud.path(), line.gouraud, a.exposure);
  write_image(phong.path(), line.phong, a.exposure);
  if (!a.csv.empty()) write_whole(a.csv, csv_of(line), a.overwrite);
  draw(figure_of(line, gouraud.path(), phong.path()), a.output, a.overwrite);
  for (const std::string& note : notes)
    if (!a.quiet) std::cerr << "note: " << printable_sentence(note) << "\n";
}

void draw_density(const Arguments& a, const Lighting& lighting) {
  const std::vector<Density> all = densities(lighting);
  if (!a.csv.empty()) write_whole(a.csv, csv_of(all), a.overwrite);
  draw(figure_of(all, lobes_of(a, lighting)), a.output, a.overwrite);
}

int draw_interpolation(const Arguments& asked) {
  Arguments a = asked;
  a.view.check();
  if (a.brdf == own_brdf && a.set.empty()) a.set = {"exponent=50", "ks=0.3", "albedo=0.35,0.35,0.35"};  // a highlight narrower than a coarse facet
  for (const std::string& file : {a.output, a.csv})
    if (!a.overwrite && !file.empty() && std::filesystem::exists(file))
      throw Error(ErrorKind::output, printable(file) + ": exists (--overwrite replaces it)");
  if (a.density && !a.input.empty()) throw Error(ErrorKind::input, "--density: makes spheres of its own, and takes no mesh");
  terminal_for(a.output, {});  // refuses another ending before any work
  const TemporaryFile rig(".json");
  const Lighting lighting = lighting_of(a, rig.path());
  a.density ? draw_density(a, lighting) : draw_scan_line(a, lighting);
  return 0;
}

}  // namespace

void figure_interpolation(CLI::App& command, Action& action) {
  const auto a = std::make_shared<Arguments>();
  command.add_option("input", a->input, "a mesh, or a G-buffer that relume bake made; default: a coarse sphere");
  command.add_option("--lights,-l", a->rigs,
                     "a rig; several are added up; default: a directional light from the upper right, and a little ambient light");
  command.add_option("--brdf", a->brdf, "the lobes: a name, or diffuse+specular")->capture_default_str();
  command.add_option("--set", a->set, "PARAM=VALUE of the lobes");
  command.add_flag("--density", a->density, "the difference between interpolations against the length of edges, for finer and finer spheres");
  command.add_option("--row", a->row, "the scan line, counted from the top; default: through the highlight")->check(CLI::NonNegativeNumber);
  command.add_option("--exposure", a->exposure, "stops, of the pictures");
  command.add_option("-o,--output", a->output, "SVG, PNG or PDF")->required();
  command.add_option("--csv", a->csv, "the numbers that are drawn");
  command.add_flag("--overwrite", a->overwrite, "replace existing files");
  command.add_flag("--quiet", a->quiet, "no notes");
  command.add_option("--device", a->device, "as for relume shade");
  a->view.usual_width = a->view.usual_height = 480;  // as large as it is drawn
  a->view.add_to(command);
  command.footer(
      "Examples:\n"
      "  relume figure interpolation -o figure.svg                              a coarse sphere: the lost highlight, Mach bands\n"
      "  relume figure interpolation mesh.glb -l rig.json -o figure.png         a mesh under a rig\n"
      "  relume figure interpolation --density --csv table.csv -o figure.pdf    how fast the two agree on finer spheres");
  command.callback([a, &action] { action = [a] { return draw_interpolation(*a); }; });
}

}  // namespace relume
