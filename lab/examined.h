// A lobe under examination: what it claims, the settings it is tried with, and its reflectance with any of them.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/lobes.h"
#include "lab/directional_albedo.h"
#include "lab/terms.h"

namespace relume {

/// PARAM=VALUE, TERM=NAME.
using Setting = std::vector<std::string>;

/// Angles of the viewer in degrees: closer where lobes change fast.
constexpr std::array furnace_angles{0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0, 88.0, 89.5};

/// A lobe in a white furnace (lab/furnace.h): of one setting, at each angle, the albedo's greatest channel and the error of it.
struct FurnaceRow {
  Setting setting;
  std::array<double, furnace_angles.size()> albedo{}, error{};
};

struct Examined {
  std::string name;
  bool diffuse = true;  ///< else specular
  std::vector<std::string> parameters;
  std::vector<std::string> claims;                                                       ///< as in the lobes' lists: "law" or "law:argument:argument"
  std::vector<Setting> grid;                                                             ///< what it is tried with
  std::function<ReflectanceOf(const Setting&)> with;                                     ///< f_r n.l of this half alone
  std::function<TermsOf(const std::string& distribution, const Setting&)> terms;         ///< the factors beside it
  std::vector<FurnaceRow> furnace;                                                       ///< of the grid, once it has been measured
  std::string full_name() const { return (diffuse ? "diffuse " : "specular ") + name; }  ///< both halves have a principled lobe
};

/// The lobe with its grid: reflectances at 1, so that it reflects all that it can; every choice of terms; each number from its lowest to its highest
/// with the others at their defaults and at their highest; all corners. `fixed`: settings of a user, which leave the grid; where they make a reflectance less
/// than 1, claims about white surfaces leave too. Error{input}.
Examined examined(const Lobe& lobe, const Setting& fixed, std::shared_ptr<Device> device);

/// `base` with other assignments, which replace those of the same name; roughness and alpha stand for each other.
Setting with_others(const Setting& base, const Setting& others);

/// What a setting says of a name; empty where it says nothing.
std::string value_in(const Setting& setting, const std::string& name);

/// "alpha=0.1 shadowing=smith"; reflectances of 1 go without saying.
std::string text_of(const Setting& setting);

}  // namespace relume
