// relume fit: analytic BRDFs beside a measured table, by how little they miss it.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/progress.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"
#include "lab/fit.h"
#include "lab/fit_figure.h"

namespace relume {
namespace {

struct FitArguments {
  std::string table, metric = "log", csv, figure, device;
  std::vector<std::string> brdfs;
  double grazing = 80;
  bool json = false, overwrite = false;
};

std::string in_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void print_table(const std::vector<Fit>& fits, const std::string& metric) {
  std::printf("%-42s %12s %12s  parameters\n", "brdf", ("rms " + metric).c_str(), "rms f_r");
  for (const Fit& fit : fits) {
    std::string parameters;
    for (const FittedParameter& p : fit.parameters) {
      parameters += (parameters.empty() ? "" : "  ") + p.name + " ";
      for (std::size_t c = 0; c < p.values.size(); ++c) parameters += (c ? "," : "") + in_digits(p.values[c]);
      if (p.at_bound) parameters += "*";
    }
    std::printf("%-42s %12.4g %12.4g  %s\n", fit.brdf.c_str(), fit.residual, fit.plain_residual, parameters.c_str());
  }
  std::printf("* at an end of its range\n");
}

nlohmann::ordered_json json_of(const std::vector<Fit>& fits, const FitArguments& a, std::size_t samples) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Fit& fit : fits) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object(), bounds = nlohmann::ordered_json::array();
    for (const FittedParameter& p : fit.parameters) {
      parameters[p.name] = p.values.size() == 1 ? nlohmann::ordered_json(p.values[0]) : nlohmann::ordered_json(p.values);
      if (p.at_bound) bounds.push_back(p.name);
    }
    all.push_back(
        {{"brdf", fit.brdf}, {"residual", fit.residual}, {"plain_residual", fit.plain_residual}, {"parameters", parameters}, {"at_bound", bounds}});
  }
  return {{"table", printable(a.table)}, {"metric", a.metric}, {"grazing", a.grazing}, {"samples", samples}, {"fits", all}};
}

/// A line for each parameter, so that BRDFs of any parameters share the columns.
void write_csv(const std::vector<Fit>& fits, const std::string& file, bool overwrite) {
  std::string text = "brdf,residual,plain_residual,parameter,r,g,b\n";
  for (const Fit& fit : fits)
    for (const FittedParameter& p : fit.parameters) {
      char head[160], values[120];
      std::snprintf(head, sizeof head, "%s,%.9g,%.9g,", fit.brdf.c_str(), fit.residual, fit.plain_residual);
      std::snprintf(values, sizeof values, ",%.9g,%.9g,%.9g\n", p.values.front(), p.values[p.values.size() / 2], p.values.back());
      text += head + p.name + values;
    }
  write_whole(file, text, overwrite);
}

void check_outputs(const FitArguments& a) {
  for (const std::string& file : {a.csv, a.figure})
    if (!file.empty() && !a.overwrite && std::filesystem::exists(file))
      throw Error(ErrorKind::output, printable(file) + ": exists (--overwrite replaces it)");
  if (!a.figure.empty()) terminal_for(a.figure, {});
}

/// The nearest first.
std::vector<Fit> fit_all(const std::vector<std::string>& brdfs, const std::vector<FitSample>& samples, FitMetric metric,
                         const std::shared_ptr<Device>& device) {
  ProgressBar progress(true);
  std::vector<Fit> fits;
  for (const std::string& brdf : brdfs) {
    progress.show("fit", double(fits.size()) / double(brdfs.size()));
    fits.push_back(fit(brdf, samples, metric, device));
  }
  std::ranges::stable_sort(fits, {}, &Fit::residual);
  return fits;
}

int run_fit(const FitArguments& a) {
  check_outputs(a);
  const FitMetric metric = fit_metric_named(a.metric);
  const MerlTable table = read_merl(a.table);
  const std::vector<FitSample> samples = fit_samples(table, metric, a.grazing, printable(a.table));
  const std::shared_ptr<Device> device = lab_device(a.device);
  const std::vector<Fit> fits = fit_all(a.brdfs.empty() ? fitted_by_default() : a.brdfs, samples, metric, device);
  if (!a.csv.empty()) write_csv(fits, a.csv, a.overwrite);
  if (!a.figure.empty()) draw(fit_figure(table, fits, a.grazing, std::filesystem::path(a.table).filename().string(), device), a.figure, a.overwrite);
  if (a.json)
    std::cout << json_of(fits, a, samples.size()).dump(2) << "\n";
  else
    print_table(fits, a.metric);
  return std::cout.flush() ? 0 : 5;
}

}  // namespace

void add_fit(CLI::App& command, Action& action) {
  const auto a = std::make_shared<FitArguments>();
  command.add_option("table", a->table, "a measured BRDF in MERL's format")->required();
  command.add_option("--brdf", a->brdfs, "BRDFs to fit: a lobe or DIFFUSE+SPECULAR; default: all that are worth it")->delimiter(',');
  command.add_option("--metric", a->metric, "log: of 1 + f_r n.l; cube_root: of f_r n.l; cosine: f_r n.l by solid angle")
      ->check(CLI::IsMember({"log", "cube_root", "cosine"}))
      ->capture_default_str();
  command.add_option("--grazing", a->grazing, "degrees from the normal beyond which light and view are left out")
      ->check(CLI::Range(1.0, 90.0))
      ->capture_default_str();
  command.add_flag("--json", a->json, "for programs");
  command.add_option("--csv", a->csv, "the same as CSV, a line for each parameter");
  command.add_option("--figure", a->figure, "slices of the table and the best fits; .svg, .png or .pdf");
  command.add_flag("--overwrite", a->overwrite, "replace existing files");
  command.add_option("--device", a->device, "as for shade; default: the best there is");
  command.footer("Example: relume fit gold.binary --figure gold.svg");
  command.callback([a, &action] { action = [a] { return run_fit(*a); }; });
}

}  // namespace relume
