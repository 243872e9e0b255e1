// Pixels that a renderer rendered (tests/data/special): normal, viewer, lights, material and the radiance that it found, one row each.
#pragma once

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/kernel_lanes.h"

namespace relume {

using Rgb = std::array<double, 3>;

class RenderedRow {
 public:
  explicit RenderedRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}

  const std::string& text(const std::string& column) const { return cells_.at(column); }
  Rgb colour(const std::string& name) const { return triple(name, {".r", ".g", ".b"}); }
  kernel::real3 vector(const std::string& name) const {
    const auto v = triple(name, {".x", ".y", ".z"});
    return kernel::real3_of(float(v[0]), float(v[1]), float(v[2]));
  }

  /// "albedo=0.1/0.2/0.3 alpha=0.3" by name; one number stands for all channels.
  std::map<std::string, Rgb> settings() const {
    std::map<std::string, Rgb> found;
    std::istringstream words(text("settings"));
    for (std::string word; words >> word;) {
      const auto equals = word.find('=');
      std::istringstream numbers(word.substr(equals + 1));
      std::vector<double> values;
      for (std::string number; std::getline(numbers, number, '/');) values.push_back(std::atof(number.c_str()));
      found[word.substr(0, equals)] = values.size() == 3 ? Rgb{values[0], values[1], values[2]} : Rgb{values[0], values[0], values[0]};
    }
    return found;
  }

  /// The surface with its settings, facing the viewer.
  kernel::Surface surface() const {
    kernel::Surface s = kernel::default_surface();
    for (const auto& [name, value] : settings()) {
      const kernel::real3 colour = kernel::real3_of(float(value[0]), float(value[1]), float(value[2]));
      if (name == "albedo")
        s.albedo = colour;
      else if (name == "base_color")
        s.base_color = colour;
      else if (name == "glossy_albedo")
        s.glossy_albedo = colour;
      else if (!kernel::set_parameter(s, name, value[0]))
        throw std::runtime_error("no parameter " + name);
    }
    s.n = s.base_n = kernel::unit3(vector("n"));
    s.v = kernel::unit3(vector("v"));
    s.n_v = kernel::dot3(s.n, s.v);
    return s;
  }

  /// What the lobe sends to the viewer under the row's lights.
  Rgb radiance(const kernel::Lobe& lobe, const kernel::Surface& s) const {
    Rgb sum{0, 0, 0};
    for (int k = 0; cells_.count("l" + std::to_string(k) + ".x") > 0; ++k) {
      const kernel::Cosines c = kernel::cosines_of(s.n, kernel::unit3(vector("l" + std::to_string(k))), s.v);
      if (!(c.n_l > 0)) continue;
      const Rgb irradiance = colour("e" + std::to_string(k));
      const kernel::real3 f = kernel::reflect_lobe(lobe, c, s);
      sum[0] += irradiance[0] * f.x, sum[1] += irradiance[1] * f.y, sum[2] += irradiance[2] * f.z;
    }
    return sum;
  }

 private:
  Rgb triple(const std::string& name, const std::array<const char*, 3>& suffixes) const {
    return {std::atof(text(name + suffixes[0]).c_str()), std::atof(text(name + suffixes[1]).c_str()), std::atof(text(name + suffixes[2]).c_str())};
  }

  std::map<std::string, std::string> cells_;
};

inline std::vector<RenderedRow> rendered_rows(const std::string& file) {
  std::ifstream in(std::string(RELUME_SOURCE) + "/tests/data/special/" + file);
  std::vector<std::string> names;
  std::vector<RenderedRow> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
    rows.emplace_back(std::move(row));
  }
  return rows;
}

inline kernel::Lobe lobe_named(const std::string& kind, const std::string& name) {
  for (const kernel::Lobe& lobe : kernel::lobes)
    if (lobe.kind == kind && lobe.name == name) return lobe;
  throw std::runtime_error("no " + kind + " lobe " + name);
}

}  // namespace relume
