// relume compare: two images, layer by layer; exit 1 above a tolerance.
#include "gbuffer/compare.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

struct CompareArguments {
  std::string image, reference;
  double tolerance = 0;
  bool json = false;
};

nlohmann::ordered_json json_of(const ImageComparison& comparison) {
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (const LayerDifference& d : comparison.layers)
    layers.push_back(
        {{"layer", d.layer},
         {"psnr", std::isfinite(d.psnr) ? nlohmann::ordered_json(d.psnr) : nlohmann::ordered_json(d.psnr > 0 ? "infinite" : "-infinite")},
         {"peak", d.peak},
         {"max_error", std::isfinite(d.max_error) ? nlohmann::ordered_json(d.max_error) : nlohmann::ordered_json("infinite")},
         {"mean_error", std::isfinite(d.mean_error) ? nlohmann::ordered_json(d.mean_error) : nlohmann::ordered_json("infinite")},
         {"worst", {{"x", d.worst_x}, {"y", d.worst_y}, {"channel", d.worst_channel}}},
         {"not_finite", d.not_finite},
         {"values", d.values}});
  return {{"layers", layers}, {"only_in_image", comparison.only_in_image}, {"only_in_reference", comparison.only_in_reference}};
}

int compare(const CompareArguments& a) {
  const ImageComparison comparison = compare_images(a.image, a.reference);
  bool within = true;
  for (const LayerDifference& d : comparison.layers) within = within && d.max_error <= a.tolerance;
  if (a.json) {
    std::cout << json_of(comparison).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return within ? 0 : 1;
  }
  std::printf("%-20s %9s %12s %12s %12s  worst pixel\n", "layer", "PSNR dB", "peak", "max error", "mean error");
  for (const LayerDifference& d : comparison.layers)
    std::printf("%-20s %9.2f %12.6g %12.6g %12.6g  (%d, %d) %s\n", d.layer.empty() ? "R G B" : printable(d.layer).c_str(), d.psnr, d.peak,
                d.max_error, d.mean_error, d.worst_x, d.worst_y, printable(d.worst_channel).c_str());
  for (const std::string& channel : comparison.only_in_image) std::printf("only in %s: %s\n", printable(a.image).c_str(), printable(channel).c_str());
  for (const std::string& channel : comparison.only_in_reference)
    std::printf("only in %s: %s\n", printable(a.reference).c_str(), printable(channel).c_str());
  return within ? 0 : 1;
}

}  // namespace

void add_compare(CLI::App& command, Action& action) {
  const auto a = std::make_shared<CompareArguments>();
  command.add_option("image", a->image, "OpenEXR")->required();
  command.add_option("reference", a->reference, "OpenEXR; its 99.9th percentile is the peak of the PSNR")->required();
  command.add_option("--tolerance", a->tolerance, "largest absolute error that exits 0")->capture_default_str();
  command.add_flag("--json", a->json, "for programs");
  command.footer("Example: relume compare relit.exr reference.exr --tolerance 1e-4");
  command.callback([a, &action] { action = [a] { return compare(*a); }; });
}

}  // namespace relume
