// relume plot: figures of BRDFs, from the kernels that shade frames.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "cli/commands.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"
#include "gbuffer/write_exr.h"
#include "lab/plots/list.h"

namespace relume {
namespace {

struct PlotArguments {
  std::string kind = "polar", output, csv, quantity = "f_r", channel = "luminance", radius, size, device;
  std::vector<std::string> brdfs, set, lobes{"total"};
  double view = 45, light = 45, mark = 0, highest = 0, exposure = 0;
  bool swap = false, overwrite = false;
};

#define RELUME_PLOT_ENTRY(kind, most, options, summary) {#kind, most, options, summary, plot_##kind},
const std::vector<PlotKind> plot_kinds{RELUME_PLOTS(RELUME_PLOT_ENTRY)};
#undef RELUME_PLOT_ENTRY

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

const PlotKind& kind_named(const std::string& name) {
  std::string names;
  for (const PlotKind& kind : plot_kinds) {
    if (kind.name == name) return kind;
    names += (names.empty() ? "" : ", ") + kind.name;
  }
  throw Error(ErrorKind::input, "no plot \"" + printable(name) + "\" (has: " + names + ")");
}

/// An option that means nothing to this kind is a mistake.
void check_options(const CLI::App& command, const PlotKind& kind) {
  const std::vector<std::string> own = words_of(kind.options);
  for (const PlotKind& other : plot_kinds)
    for (const std::string& option : words_of(other.options)) {
      const bool taken = std::find(own.begin(), own.end(), option) != own.end();
      if (taken || command.get_option("--" + option)->count() == 0) continue;
      std::string all;
      for (const std::string& word : own) all += " --" + word;
      throw Error(ErrorKind::input, "plot " + kind.name + ": takes no --" + option + " (takes:" + all + ")");
    }
}

template <class Value>
Value chosen(const std::string& option, const std::string& text, const std::vector<std::pair<std::string, Value>>& choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    names += (names.empty() ? "" : ", ") + name;
  }
  throw Error(ErrorKind::input, option + " " + printable(text) + ": is none of " + names);
}

double angle_of(const char* option, double degrees) {
  if (!(degrees >= 0 && degrees < 90)) throw Error(ErrorKind::input, std::string(option) + ": degrees from the normal, 0 to below 90");
  return degrees;
}

Arrangement arrangement_of(const CLI::App& command, const PlotArguments& a) {
  const bool view = command.get_option("--view")->count() > 0, light = command.get_option("--light")->count() > 0;
  if (view && light) throw Error(ErrorKind::input, "--view, --light: one of them stands still, the other moves (--mark draws one where it moves)");
  return {light, light ? angle_of("--light", a.light) : angle_of("--view", a.view)};
}

Measure measure_of(const PlotArguments& a) {
  return {
      chosen<Quantity>("--quantity", a.quantity, {{"f_r", Quantity::f_r}, {"reflectance", Quantity::reflectance}}),
      chosen<ColourChannel>("--channel", a.channel,
                            {{"luminance", ColourChannel::luminance}, {"r", ColourChannel::r}, {"g", ColourChannel::g}, {"b", ColourChannel::b}})};
}

std::vector<LobePart> parts_of(const PlotArguments& a) {
  std::vector<LobePart> parts;
  for (const std::string& lobe : a.lobes) {
    const LobePart part =
        chosen<LobePart>("--lobes", lobe, {{"total", LobePart::total}, {"diffuse", LobePart::diffuse}, {"specular", LobePart::specular}});
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  }
  return parts;
}

PlotRequest request_of(const CLI::App& command, const PlotArguments& a, const PlotKind& kind) {
  const auto given = [&](const char* option) { return command.get_option(option)->count() > 0; };
  // NaN is in no range.
  if (given("--mark") && !(std::abs(a.mark) < 90)) throw Error(ErrorKind::input, "--mark: degrees from the normal, above -90 to below 90");
  if (given("--highest") && !(a.highest >= 1e-9 && a.highest <= 1e9)) throw Error(ErrorKind::input, "--highest: a value above 0 (1e-9 to 1e9)");
  if (!(std::abs(a.exposure) <= 30)) throw Error(ErrorKind::input, "--exposure: stops, -30 to 30");
  PlotRequest request;
  request.compared = compared(a.brdfs, a.set, kind.most);
  request.arrangement = arrangement_of(command, a);
  if (given("--mark")) request.marked = a.mark;
  if (given("--highest")) request.highest = a.highest;
  if (given("--radius"))
    request.scale =
        chosen<ScaleKind>("--radius", a.radius, {{"linear", ScaleKind::linear}, {"log", ScaleKind::log}, {"cube_root", ScaleKind::cube_root}});
  request.measure = measure_of(a);
  request.parts = parts_of(a);
  request.swap = a.swap;
  request.exposure = a.exposure;
  request.numbers = !a.csv.empty();
  return request;
}

void resize(Figure& figure, const std::string& text) {
  int end = 0;
  const bool whole = std::sscanf(text.c_str(), "%dx%d%n", &figure.width, &figure.height, &end) == 2 && end == int(text.size());
  constexpr int least = 200, most = 8192;
  if (!whole || figure.width < least || figure.height < least || figure.width > most || figure.height > most)
    throw Error(ErrorKind::input, "--size " + printable(text) + ": no size (WIDTHxHEIGHT, each 200 to 8192)");
}

/// The scene-linear picture behind a figure.
void write_exr(const Plot& plot, const PlotArguments& a) {
  if (!plot.picture) throw Error(ErrorKind::input, printable(a.output) + ": a plot of " + a.kind + " ends in .svg, .png or .pdf");
  const Picture& p = *plot.picture;
  const Window window{0, 0, p.width, p.height};
  OutputFormat format;
  format.overwrite = a.overwrite;
  ExrWriter writer(a.output, format, Imf::Header(p.width, p.height), window, window, {"R", "G", "B"}, {});
  std::vector<Source> sources;
  const std::size_t pixel = 3 * sizeof(float);
  for (int c = 0; c < 3; ++c) sources.push_back({std::string(1, "RGB"[c]), p.values.data() + c, pixel, pixel * std::size_t(p.width)});
  writer.write_rows(p.height, sources);
  writer.commit();
}

int plot(const CLI::App& command, const PlotArguments& a) {
  const PlotKind& kind = kind_named(a.kind);
  check_options(command, kind);
  if (a.output.empty() && a.csv.empty()) throw Error(ErrorKind::input, "plot: nothing to write (-o FILE.svg, .png or .pdf; --csv FILE)");
  Figure size;
  if (!a.size.empty()) resize(size, a.size);
  if (a.output == a.csv) throw Error(ErrorKind::input, "--csv " + printable(a.csv) + ": is the figure's file");
  const bool as_exr = std::filesystem::path(a.output).extension() == ".exr";
  if (!a.output.empty() && !as_exr) terminal_for(a.output, size);
  PlotRequest request = request_of(command, a, kind);
  request.device = lab_device(a.device);
  Plot made = kind.make(request);
  if (!a.size.empty()) resize(made.figure, a.size);
  if (as_exr)
    write_exr(made, a);
  else if (!a.output.empty())
    draw(made.figure, a.output, a.overwrite);
  if (!a.csv.empty()) write_whole(a.csv, made.csv, a.overwrite);
  for (const std::string& remark : made.remarks) std::cout << remark << "\n";
  return 0;
}

std::string kinds_help() {
  std::string text;
  for (const PlotKind& kind : plot_kinds) {
    text += (text.empty() ? "" : "\n") + kind.name + ": " + kind.summary + " (";
    for (const std::string& option : words_of(kind.options)) text += (text.ends_with("(") ? "--" : " --") + option;
    text += ")";
  }
  return text;
}

}  // namespace

void add_plot(CLI::App& command, Action& action) {
  const auto a = std::make_shared<PlotArguments>();
  command.add_option("kind", a->kind, "polar (the default) or another kind, see below");
  const auto with_commas = [](CLI::Option* option) { return option->delimiter(',')->allow_extra_args(false); };
  with_commas(command.add_option("--brdf", a->brdfs, "lobes or pairs, with commas: phong,lambert+ggx (relume list brdfs)"))->required();
  command.add_option("--set", a->set, "PARAM=VALUE; several values with commas are compared (of rgb parameters with ;)")->allow_extra_args(false);
  command.add_option("--view", a->view, "the view direction stands at so many degrees, light moves. Default: 45");
  command.add_option("--light", a->light, "the light direction stands at so many degrees, the viewer moves; spheres: degrees from the viewer");
  command.add_option("--mark", a->mark, "draw a moving direction at so many degrees (positive: on the mirror direction's side), and h");
  command.add_option("--quantity", a->quantity, "f_r, or reflectance: f_r n.l. Default: f_r");
  command.add_option("--radius,--scale", a->radius, "linear, log (four decades and more) or cube_root: lengths, or a map's colours");
  command.add_option("--channel", a->channel, "r, g, b or luminance (BT.709, the default)");
  command.add_option("--highest", a->highest, "the value at the rim, or of the last colour. Default: the highest there is");
  with_commas(command.add_option("--lobes", a->lobes, "total, diffuse, specular: several with commas are shown apart. Default: total"));
  command.add_option("--exposure", a->exposure, "stops. Default: 0");
  command.add_flag("--swap", a->swap, "also with view and light exchanged: what is reciprocal coincides");
  command.add_option("-o,--output", a->output, "FILE.svg, .png or .pdf (made by gnuplot); of spheres also .exr, scene-linear");
  command.add_option("--csv", a->csv, "FILE for the numbers, a row for each sample");
  command.add_option("--size", a->size, "WIDTHxHEIGHT in pixels of the PNG; SVG and PDF have the same shape");
  command.add_flag("--overwrite", a->overwrite, "replace existing files");
  command.add_option("--device", a->device, "as for shade; default: the best there is");
  command.footer(kinds_help() + "\nExample: relume plot --brdf phong,blinn_phong,cook_torrance --set exponent=8,32,128 --view 30 -o lobes.svg");
  command.callback([a, &command, &action] { action = [a, &command] { return plot(command, *a); }; });
}

}  // namespace relume
