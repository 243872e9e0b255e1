// relume figure environment: the lecture's comparison of light from everywhere with light from one point and black elsewhere.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "cli/environment_arguments.h"
#include "cli/figures/list.h"
#include "figure/figure.h"
#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"
#include "gbuffer/picture.h"
#include "gbuffer/printable.h"
#include "host/environment_lights.h"
#include "host/relight.h"

namespace relume {
namespace {

struct FigureArguments {
  std::string gbuffer, rig, output, materials, diffuse = "auto", specular = "auto", device;
  std::vector<std::string> set;
  bool overwrite = false;
  EnvironmentArguments environments;
};

/// For what is shaded before it is drawn.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "relume-figure-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error(ErrorKind::output, name + ": no temporary folder can be made (TMPDIR names another place)");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

Light environment_in(const std::string& rig) {
  for (const Light& light : read_rig(rig, {}).lights)
    if (light.type == LightType::environment) return light;
  throw Error(ErrorKind::input, printable(rig) + ": has no environment light (\"type\": \"environment\"), which this figure compares with one point");
}

RelightJob job_of(const FigureArguments& a) {
  RelightJob job;
  job.gbuffer = a.gbuffer;
  job.rigs = {a.rig};
  if (a.diffuse != "auto") job.material.diffuse = a.diffuse;
  if (a.specular != "auto") job.material.specular = a.specular;
  for (const std::string& assignment : a.set) set_parameter(job.material, assignment);
  check(job.material, "command line");
  if (!a.materials.empty()) job.materials = a.materials;
  job.device = a.device;
  job.environments = a.environments.options();
  return job;
}

Picture shaded(RelightJob job, const std::filesystem::path& to, bool brightest_alone) {
  job.output = to;
  job.environments.brightest_alone = brightest_alone;
  relight(job, {});
  const ExrFile file(to);
  const Window& window = file.parts().front().data_window;
  Picture picture{window.width(), window.height(), 3, std::vector<float>(std::size_t(window.pixels()) * 3)};
  std::vector<Destination> channels;
  constexpr std::size_t pixel = 3 * sizeof(float);
  for (std::size_t c = 0; c < 3; ++c)
    channels.push_back({std::string(1, "RGB"[c]), SampleType::float32, &picture.values[c], pixel, pixel * std::size_t(window.width())});
  file.read(0, window, channels);
  return picture;
}

Picture as_picture(const EnvironmentMap& map) {
  Picture picture{map.width, map.height, 3, {}};
  for (const std::array<float, 3>& texel : map.radiance) picture.values.insert(picture.values.end(), texel.begin(), texel.end());
  return picture;
}

/// The gain that makes the 99th percentile of what is not black 0.8: few highlights are cut off.
double gain_for(const Picture& picture) {
  std::vector<float> lit;
  std::copy_if(picture.values.begin(), picture.values.end(), std::back_inserter(lit), [](float x) { return x > 0; });
  if (lit.empty()) return 1;
  const auto rank = lit.begin() + std::ptrdiff_t(double(lit.size() - 1) * 0.99);
  std::nth_element(lit.begin(), rank, lit.end());
  return 0.8 / *rank;
}

/// At most so wide: means over squares of pixels.
Picture reduced(const Picture& picture, int widest) {
  const int step = (picture.width + widest - 1) / widest;
  Picture small{picture.width / step, std::max(1, picture.height / step), 3, {}};
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int k = 0; k < step * step; ++k) {
          const int row = std::min(y * step + k / step, picture.height - 1);
          sum += picture.values[(std::size_t(row) * std::size_t(picture.width) + std::size_t(x * step + k % step)) * 3 + std::size_t(c)];
        }
        small.values.push_back(float(sum / (step * step)));
      }
  return small;
}

/// As gnuplot's data: "x y r g b", y upwards.
std::string data_block(const std::string& name, const Picture& picture, double gain) {
  std::string text = "$" + name + " << END\n";
  for (std::size_t i = 0; i < picture.values.size() / 3; ++i) {
    const std::size_t width = std::size_t(picture.width);
    text += std::to_string(i % width) + " " + std::to_string(std::size_t(picture.height) - 1 - i / width);
    for (std::size_t c = 0; c < 3; ++c) text += " " + std::to_string(srgb_code(float(gain * picture.values[3 * i + c])));
    text += "\n";
  }
  return text + "END\n";
}

/// A rectangle of the page, in pixels from its upper left corner.
struct Place {
  double left, top, width, height;
};

constexpr int page_width = 1000, picture_width = 470, map_width = 320, gap = 20, title_height = 34, caption_height = 64;

/// A picture in its place, its title above it; `more`: what is plotted over it.
std::string panel(const std::string& name, const Picture& picture, const std::string& title, const Place& place, double page_height,
                  const std::string& more = {}) {
  const auto screen = [](const char* margin, double at) { return std::string("set ") + margin + " at screen " + std::to_string(at) + "\n"; };
  std::string text = screen("lmargin", place.left / page_width) + screen("rmargin", (place.left + place.width) / page_width) +
                     screen("tmargin", 1 - place.top / page_height) + screen("bmargin", 1 - (place.top + place.height) / page_height);
  text += "set xrange [-0.5:" + std::to_string(picture.width) + "-0.5]\nset yrange [-0.5:" + std::to_string(picture.height) + "-0.5]\n";
  text += "set title " + quoted(title) + " offset 0,-0.6\n";
  return text + "plot $" + name + " using 1:2:3:4:5 with rgbimage notitle" + more + "\n";
}

/// Both pictures side by side, beneath each the image that its light comes from.
Figure figure_of(const Picture& whole, const Picture& point, const EnvironmentMap& map) {
  const Picture all = reduced(whole, picture_width), one = reduced(point, picture_width);
  const Picture sky = reduced(as_picture(map), map_width), dark = reduced(as_picture(brightest_alone(map)), map_width);
  const double gain = gain_for(whole), sky_gain = gain_for(sky);
  const double height = double(picture_width) * all.height / all.width, map_height = double(map_width) * sky.height / sky.width;
  const double maps_top = title_height + height + title_height + 6, page = maps_top + map_height + caption_height;
  const double right = page_width - gap - picture_width, inset = (picture_width - map_width) / 2.0;
  const auto brightest = std::size_t(std::max_element(dark.values.begin(), dark.values.end()) - dark.values.begin()) / 3;
  Figure figure;
  figure.width = page_width;
  figure.height = int(page);
  figure.data = data_block("whole", all, gain) + data_block("point", one, gain) + data_block("sky", sky, sky_gain) +
                data_block("dark", dark, sky_gain) + "$ring << END\n" + std::to_string(brightest % std::size_t(dark.width)) + " " +
                std::to_string(std::size_t(dark.height) - 1 - brightest / std::size_t(dark.width)) + "\nEND\n";
  figure.commands = "set multiplot\nunset border\nunset tics\nunset grid\nunset key\n";
  figure.commands += panel("whole", all, "Light from the whole environment", {gap, title_height, picture_width, height}, page);
  figure.commands += panel("point", one, "The same energy from one point, black elsewhere", {right, title_height, picture_width, height}, page);
  figure.commands += "set border 15 lc rgb '#888888'\n";
  figure.commands += panel("sky", sky, "the environment", {gap + inset, maps_top, map_width, map_height}, page);
  const auto caption = [&](int line, const char* text) {
    figure.commands += "set label " + std::to_string(line) + " " + quoted(text) + " at screen 0.5, screen " +
                       std::to_string((caption_height - 20.0 * line) / page) + " center\n";
  };
  caption(1, "Same surfaces, camera and exposure. The point is the environment's brightest texel (ringed),");
  caption(2, "which is given all of the environment's energy: the pictures differ by where light comes from alone.");
  figure.commands += panel("dark", dark, "its brightest texel", {right + inset, maps_top, map_width, map_height}, page,
                           ", $ring using 1:2 with points pt 6 ps 2.2 lw 2 lc rgb '#E69F00' notitle");
  figure.commands += "unset multiplot\n";
  return figure;
}

int draw_environment(const FigureArguments& a) {
  terminal_for(a.output, {});  // refuses another ending before the work
  if (!a.overwrite && std::filesystem::exists(a.output)) throw Error(ErrorKind::output, printable(a.output) + ": exists (--overwrite replaces it)");
  const Light light = environment_in(a.rig);
  const RelightJob job = job_of(a);
  const ScratchFolder scratch;
  const Picture whole = shaded(job, scratch / "whole.exr", false), point = shaded(job, scratch / "point.exr", true);
  draw(figure_of(whole, point, read_environment(light.texture, *light.mapping)), a.output, a.overwrite);
  return 0;
}

}  // namespace

void figure_environment(CLI::App& command, Action& action) {
  const auto a = std::make_shared<FigureArguments>();
  a->environments.chosen.samples = 256;  // a figure is to show no grain
  command.add_option("gbuffer", a->gbuffer, "an OpenEXR file with normals and positions")->required();
  command.add_option("--lights,-l", a->rig, "a rig in Relume's JSON with an environment light; other lights shine in both pictures")->required();
  command.add_option("-o,--output", a->output, "the figure: .png, .svg or .pdf")->required();
  command.add_option("--diffuse", a->diffuse, "diffuse lobe, none, or auto");
  command.add_option("--specular", a->specular, "specular lobe, none, or auto");
  command.add_option("--set", a->set, "PARAM=VALUE: a constant for a parameter");
  command.add_option("--materials", a->materials, "a material file");
  command.add_option("--device", a->device, "cpu, gpu, twin, an index, or part of a platform's or device's name");
  command.add_flag("--overwrite", a->overwrite, "replace an existing output");
  a->environments.add_to(command);
  command.footer("Example: relume figure environment shot.exr --lights rig.json -o environment.png");
  command.callback([a, &action] { action = [a] { return draw_environment(*a); }; });
}

}  // namespace relume
