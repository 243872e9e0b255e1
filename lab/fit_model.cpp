// FitModel: samples times sets as rows of a band, parameters as its layers.
#include "lab/fit_model.h"

#include <algorithm>
#include <cmath>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"
#include "host/brdf_name.h"
#include "host/row_band.h"
#include "host/self_test.h"

namespace relume {
namespace {

/// Steps of a share of such a range, not of the number, are alike to the eye.
bool spans_decades(const Parameter& p) { return p.highest >= 100 * std::max(p.lowest, 1.0) || (p.lowest > 0 && p.highest >= 100 * p.lowest); }

/// So that the logarithm of a range that begins at 0 begins somewhere.
double offset_of(const Parameter& p) { return p.lowest > 0 ? 0 : 1; }

const Lobe* lobe_of(const Material& material, bool diffuse) { return find_lobe(diffuse, diffuse ? material.diffuse : material.specular); }

/// What stands for something else that is fitted, or mixes the channels, which a fit moves together; switches are no numbers.
bool is_left_alone(const Lobe& lobe, const Parameter& p) {
  const auto has = [&](const char* name) { return std::ranges::find(lobe.parameters, name) != lobe.parameters.end(); };
  if (p.from_host || p.is_file || p.is_switch) return true;
  if (p.name == "roughness" && has("alpha")) return true;
  if (p.name == "ior" && has("specular_level")) return true;
  return p.name == "sheen_tint" || p.name == "spec_tint";
}

}  // namespace

double FreeParameter::value_at(double u) const {
  const double share = (std::sin(u) + 1) / 2, low = parameter->lowest, high = parameter->highest, offset = offset_of(*parameter);
  const double value =
      spans_decades(*parameter) ? (low + offset) * std::pow((high + offset) / (low + offset), share) - offset : low + (high - low) * share;
  return std::clamp(value, low, high);
}

double FreeParameter::coordinate_of(double value) const {
  const double low = parameter->lowest, high = parameter->highest, offset = offset_of(*parameter);
  const double share = spans_decades(*parameter) ? std::log((value + offset) / (low + offset)) / std::log((high + offset) / (low + offset))
                                                 : (value - low) / (high - low);
  return std::asin(std::clamp(2 * share - 1, -1.0, 1.0));
}

FitModel::FitModel(const std::string& brdf, std::span<const FitSample> samples, std::shared_ptr<Device> device)
    : brdf_(brdf), material_(material_named(brdf)), device_(std::move(device)) {
  for (const FitSample& sample : samples) cosines_.push_back(cosines_of(sample.pair));
  choose_free_parameters();
  for (const FreeParameter& p : free_) material_.parameters[p.name] = LayerValue{p.name};
  check(material_, printable(brdf));
}

void FitModel::choose_free_parameters() {
  const auto add = [&](std::string_view name) {
    const std::string users = name == "base_color" ? "albedo" : std::string(name);
    if (std::ranges::any_of(free_, [&](const FreeParameter& p) { return p.name == users; })) return;
    free_.push_back({&parameter_named(name), users, coordinates_});
    coordinates_ += parameter_named(name).components;
  };
  for (const bool diffuse : {true, false}) {
    const Lobe* lobe = lobe_of(material_, diffuse);
    if (!lobe) continue;
    if (lobe->name == "plastic")
      throw Error(ErrorKind::input, "--brdf " + printable(brdf_) + ": plastic's table is made for constants: no fit finds them");
    for (const std::string_view name : lobe->parameters)
      if (!is_left_alone(*lobe, parameter_named(name))) add(name);
    if (const Term* fresnel = fresnel_of(material_, *lobe); fresnel && std::ranges::find(fresnel->parameters, "f0") != fresnel->parameters.end())
      add("f0");
  }
  if (free_.empty()) throw Error(ErrorKind::input, "--brdf " + printable(brdf_) + ": has no parameter to fit");
}

std::vector<Eigen::VectorXd> FitModel::reflectance(const std::vector<Eigen::VectorXd>& sets) {
  beat();
  const std::size_t samples = cosines_.size();
  std::vector<PreciseCosines> cosines;
  for (std::size_t k = 0; k < sets.size(); ++k) cosines.insert(cosines.end(), cosines_.begin(), cosines_.end());
  RowBand rows(cosines);
  for (const FreeParameter& p : free_) {
    std::vector<std::vector<double>> columns(std::size_t(p.parameter->components));
    for (const Eigen::VectorXd& set : sets)
      for (std::size_t c = 0; c < columns.size(); ++c) columns[c].insert(columns[c].end(), samples, p.value_at(set[p.first + int(c)]));
    rows.add_parameter(p.name, columns);
  }
  if (!binding_) {
    const LayerFinder no_layers = [](const std::string& layer) -> RoleLayer { throw Error(ErrorKind::internal, "fit: no column " + layer); };
    binding_.emplace(material_, std::nullopt, brdf_, no_layers, rows.reading());
    if (device_->info().name != "twin") self_test(*device_, binding_->programs().front());
  }
  const Planes out = rows.evaluate(*device_, *binding_);
  std::vector<Eigen::VectorXd> values(sets.size(), Eigen::VectorXd(Eigen::Index(3 * samples)));
  for (std::size_t k = 0; k < sets.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < samples; ++i)
        values[k][Eigen::Index(c * samples + i)] = double(out.plane(int(c))[k * samples + i]) + double(out.plane(int(c) + 3)[k * samples + i]);
  return values;
}

}  // namespace relume
