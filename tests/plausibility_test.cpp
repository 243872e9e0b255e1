// The laboratory's integrals against tables made in double precision, and its laws on functions that keep and break them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "lab/directional_albedo.h"

namespace relume {
namespace {

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// A table's model: our BRDF, settings, and what its parameters are called here.
struct Model {
  std::string brdf;
  std::vector<std::string> set;
  std::map<std::string, std::string> names;
};

// beckmann_smith_exact_nofresnel is Smith with the error function, and ours the rational fit to it; phong_original's table has f n.l as ours.
const std::map<std::string, Model> kModels{
    {"lambert", {"lambert", {}, {{"rho", "albedo"}}}},
    {"oren_nayar_qualitative", {"oren_nayar", {"albedo=1"}, {{"sigma_rad", "sigma"}}}},
    {"eon", {"eon", {}, {{"rho", "albedo"}, {"roughness", "sigma_r"}}}},
    {"disney_diffuse", {"burley", {"albedo=1"}, {}}},
    {"phong_original", {"phong_original", {"ks=1"}, {}}},
    {"phong_plausible", {"phong", {"ks=1"}, {}}},
    {"blinn_phong_ndf", {"blinn_phong", {"ks=1"}, {}}},
    {"blinn_phong_exact", {"blinn_phong_exact", {"ks=1"}, {}}},
    {"cook_torrance_beckmann_vgroove_nofresnel", {"cook_torrance", {"fresnel=none", "ks=1", "shadowing=v_groove"}, {}}},
    {"beckmann_smith_rational_nofresnel", {"beckmann", {"fresnel=none", "ks=1", "shadowing=smith_separable"}, {}}},
    {"beckmann_rational_conductor", {"beckmann", {"fresnel=conductor", "shadowing=smith_separable"}, {}}},
    {"ggx_smith_separable_nofresnel", {"ggx", {"fresnel=none", "ks=1", "shadowing=smith_separable"}, {}}},
    {"ggx_smith_correlated_nofresnel", {"ggx", {"fresnel=none", "ks=1", "shadowing=smith"}, {}}},
    {"ggx_correlated_schlick", {"ggx", {"fresnel=schlick", "shadowing=smith"}, {}}},
    {"ggx_separable_conductor", {"ggx", {"fresnel=conductor", "shadowing=smith_separable"}, {}}},
    {"principled_base_specular", {"principled", {"ior=1.5"}, {{"base", "albedo"}, {"specular", "specular_level"}}}},
};

TEST(DirectionalAlbedo, AgreesWithTheTables) {
  std::ifstream in(RELUME_SOURCE "/tests/data/oracle/albedo.csv");
  std::string line;
  std::getline(in, line);
  std::map<std::string, std::map<double, double>> wanted;
  while (std::getline(in, line)) {
    const auto cells = parts_of(line, ',');
    if (kModels.contains(cells[0])) wanted[cells[0] + "," + cells[1]][std::stod(cells[2])] = std::stod(cells[3]);
  }
  const auto device = lab_device("twin");
  double worst = 0; std::size_t all=0; double bound=0;
  auto t0=std::chrono::steady_clock::now();
  for (const auto& [name, table] : wanted) {
    const auto cells = parts_of(name, ',');
    const Model& model = kModels.at(cells[0]);
    std::vector<std::string> set = model.set;
    for (const std::string& assignment : parts_of(cells[1], ';')) {
      const auto sides = parts_of(assignment, '=');
      set.push_back((model.names.contains(sides[0]) ? model.names.at(sides[0]) : sides[0]) + "=" + sides[1]);
    }
    const Brdf brdf(model.brdf, set, device);
    std::vector<double> views;
    for (const auto& [n_v, albedo] : table) views.push_back(n_v);
    std::size_t asked = 0;
    auto t1=std::chrono::steady_clock::now();
    const auto ours = directional_albedos([&](auto pairs) { asked += pairs.size(); return brdf.reflectance(pairs); }, views, getenv("TOL")?atof(getenv("TOL")):1e-6);
    double w=0;
    for (std::size_t i = 0; i < views.size(); ++i) { if(name=="phong_original,exponent=1") printf("%g %.9f %.9f\n",views[i],ours[i].total().value.x,table.at(views[i])); w=std::max(w,std::abs(ours[i].total().value.x - table.at(views[i]))); bound=std::max(bound,ours[i].total().error.x);
      EXPECT_NEAR(ours[i].total().value.x, table.at(views[i]), 1e-5) << name << " " << views[i]; }
    printf("%-60s %9zu asked, %.1e  %.0f ms\n", name.c_str(), asked/views.size(), w, 1e3*std::chrono::duration<double>(std::chrono::steady_clock::now()-t1).count());
    worst=std::max(worst,w); all+=asked;
  }
  printf("worst %g bound %g asked %zu  %.2f s\n", worst, bound, all, std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count());
}

}  // namespace
}  // namespace relume
