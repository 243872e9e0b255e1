// Ambient light: the fixed quadrature of kernels/ambient.h against dense integrals and the double-precision oracle, then the program's ambient
// lights and layers. Prints the table of errors.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "host/ambient_nodes.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/reflectance.h"
#include "tests/run_program.h"

namespace relume {
namespace {

constexpr std::array view_cosines{1.0, 0.9, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05};

const kernel::Lobe& lobe_of(const std::string& kind, const std::string& name) {
  for (const kernel::Lobe& lobe : kernel::lobes)
    if (lobe.kind == kind && lobe.name == name) return lobe;
  throw std::runtime_error("no lobe " + name);
}

/// A lobe with settings, as "alpha=0.3 fresnel=none".
struct Case {
  const char *kind, *name, *settings;
  int width_rule;
};

/// With the lobe's first shadowing term where the settings name none.
kernel::Surface surface_of(const Case& test) {
  kernel::Surface s = kernel::default_surface();
  const std::string_view terms = lobe_of(test.kind, test.name).shadowings;
  if (!terms.empty()) s.shadowing = kernel::shadowing_named(terms.substr(0, terms.find(' ')));
  std::istringstream words(test.settings);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
    if (key == "fresnel")
      s.fresnel = kernel::fresnel_named(value);
    else if (key == "shadowing")
      s.shadowing = kernel::shadowing_named(value);
    else if (key == "distribution")
      s.distribution = kernel::distribution_named(value);
    else
      EXPECT_TRUE(kernel::set_parameter(s, key, std::stod(value))) << key;
  }
  return s;
}

/// What the kernel says that a surface reflects of light from everywhere.
double by_quadrature(const Case& test, kernel::Surface s, double n_v) {
  static const std::vector<float> nodes = ambient_nodes();
  kernel::Frame frame{};
  frame.node_count = int(nodes.size() / 4);
  frame.width_rule = test.width_rule;
  s.tables = nodes.data();
  s.n_v = float(n_v);
  s.v = kernel::real3_of(float(std::sqrt(1 - n_v * n_v)), 0, float(n_v));
  const kernel::Lobe& lobe = lobe_of(test.kind, test.name);
  const bool diffuse = lobe.kind == "diffuse";
  const kernel::Choice choice{diffuse ? lobe.number : 0, diffuse ? 0 : lobe.number, s.fresnel, s.shadowing, s.distribution};
  s = kernel::looked_up(choice, s);
  const kernel::Basis basis = kernel::basis_of(s.n, s.v);
  return diffuse ? kernel::diffuse_albedo(choice, &frame, s, basis).x : kernel::specular_albedo(choice, &frame, s, basis).x;
}

/// `steep`: the largest error below n.v = 0.2, where the horizon cuts through the lobe.
struct Bound {
  Case test;
  double usual, steep;
};

constexpr auto alpha = kernel::WIDTH_alpha, rough = kernel::WIDTH_roughness, blinn = kernel::WIDTH_exponent, chord = kernel::WIDTH_chord_exponent;

// phong_original does not fade towards the horizon: a step that no fixed rule meets. V-grooves crease there. The glossiest clearcoat (alpha 0.001, an
// albedo of 0.014) falls between the nodes that suit the base lobe.
constexpr Bound bounds[] = {
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.01", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.05", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.1", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.3", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.5", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=1", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "alpha=0.3", alpha}, 2e-3, 2e-2},
    {{"specular", "ggx", "fresnel=none ks=1 alpha=0.5 shadowing=smith_separable", alpha}, 2e-3, 2e-2},
    {{"specular", "beckmann", "fresnel=none ks=1 alpha=0.05", alpha}, 2e-3, 2e-2},
    {{"specular", "beckmann", "fresnel=none ks=1 alpha=0.3", alpha}, 2e-3, 2e-2},
    {{"specular", "beckmann", "fresnel=none ks=1 alpha=1", alpha}, 2e-3, 2e-2},
    {{"specular", "cook_torrance", "fresnel=none ks=1 alpha=0.05", alpha}, 2e-3, 2e-2},
    {{"specular", "cook_torrance", "fresnel=none ks=1 alpha=0.3", alpha}, 4e-3, 2e-2},
    {{"specular", "cook_torrance", "fresnel=none ks=1 alpha=1", alpha}, 4e-3, 2e-2},
    {{"specular", "phong", "ks=1 exponent=1", chord}, 2e-3, 2e-2},
    {{"specular", "phong", "ks=1 exponent=20", chord}, 2e-3, 2e-2},
    {{"specular", "phong", "ks=1 exponent=100", chord}, 2e-3, 2e-2},
    {{"specular", "phong", "ks=1 exponent=1000", chord}, 3e-3, 2e-2},
    {{"specular", "phong_original", "ks=1 exponent=1", chord}, 2.5e-2, 2e-2},
    {{"specular", "phong_original", "ks=1 exponent=20", chord}, 6e-3, 2e-2},
    {{"specular", "phong_original", "ks=1 exponent=100", chord}, 2e-3, 2e-2},
    {{"specular", "blinn_phong", "ks=1 exponent=1", blinn}, 2e-3, 2e-2},
    {{"specular", "blinn_phong", "ks=1 exponent=20", blinn}, 2e-3, 2e-2},
    {{"specular", "blinn_phong", "ks=1 exponent=1000", blinn}, 2e-3, 2e-2},
    {{"specular", "cycles_glossy", "distribution=ggx roughness=0.01", rough}, 2e-3, 2e-2},
    {{"specular", "cycles_glossy", "distribution=ggx roughness=0.5", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "metallic=1 albedo=1 roughness=0", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "metallic=1 albedo=1 roughness=0.2", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "metallic=1 albedo=1 roughness=0.5", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "metallic=1 albedo=1 roughness=1", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "roughness=0.5 clearcoat=1", rough}, 2e-3, 2e-2},
    {{"specular", "principled", "roughness=0.5 clearcoat=1 clearcoat_gloss=1", rough}, 2e-2, 2e-2},
    {{"diffuse", "burley", "albedo=1 roughness=0.2", alpha}, 2e-3, 2e-2},
    {{"diffuse", "burley", "albedo=1 roughness=1", alpha}, 2e-3, 2e-2},
    {{"diffuse", "oren_nayar", "albedo=1 sigma=0.2", alpha}, 2e-3, 2e-2},
    {{"diffuse", "oren_nayar", "albedo=1 sigma=1", alpha}, 2e-3, 2e-2},
    {{"diffuse", "eon", "albedo=1 sigma_r=0.2", alpha}, 2e-3, 2e-2},
    {{"diffuse", "eon", "albedo=1 sigma_r=1", alpha}, 2e-3, 2e-2},
    {{"diffuse", "principled", "albedo=1 roughness=0.5", alpha}, 2e-3, 2e-2},
    {{"diffuse", "principled", "albedo=1 roughness=0.5 sheen=1", alpha}, 2e-3, 2e-2},
    {{"diffuse", "plastic", "albedo=0.5", alpha}, 2e-3, 2e-2},
    {{"diffuse", "cycles", "albedo=1 diffuse_roughness=0.5", alpha}, 2e-3, 2e-2},
};

TEST(Ambient, QuadratureAgainstDenseIntegrals) {
  std::printf("error of the albedo at n.v = ");
  for (const double n_v : view_cosines) std::printf("%9g", n_v);
  std::printf("\n");
  for (const Bound& bound : bounds) {
    const kernel::Surface s = surface_of(bound.test);
    const kernel::Lobe& lobe = lobe_of(bound.test.kind, bound.test.name);
    std::printf("%-12s%-34s", bound.test.name, bound.test.settings);
    for (const double n_v : view_cosines) {
      const double dense = directional_albedo(lobe, s, n_v, half_vector_width(lobe, s), 240);
      const double error = by_quadrature(bound.test, s, n_v) - dense;
      std::printf(" %8.1e", error);
      EXPECT_LE(std::fabs(error), n_v >= 0.2 ? bound.usual : bound.steep) << bound.test.name << " " << bound.test.settings << " at " << n_v;
    }
    std::printf("\n");
  }
}

TEST(Ambient, QuadratureAgainstTheOracle) {
  std::ifstream table(std::string(RELUME_SOURCE) + "/tests/data/oracle/albedo.csv");
  const std::map<std::string, std::pair<const char*, const char*>> models{
      {"ggx_smith_correlated_nofresnel", {"ggx", "fresnel=none ks=1 shadowing=smith"}},
      {"ggx_smith_separable_nofresnel", {"ggx", "fresnel=none ks=1 shadowing=smith_separable"}},
      {"beckmann_smith_rational_nofresnel", {"beckmann", "fresnel=none ks=1 shadowing=smith_separable"}},
      {"cook_torrance_beckmann_vgroove_nofresnel", {"cook_torrance", "fresnel=none ks=1 shadowing=v_groove"}}};
  int rows = 0;
  for (std::string model, parameters, n_v, albedo;
       std::getline(table, model, ',') && std::getline(table, parameters, ',') && std::getline(table, n_v, ',') && std::getline(table, albedo);) {
    const auto found = models.find(model);
    if (found == models.end()) continue;
    const std::string settings = std::string(found->second.second) + " " + parameters;
    const Case test{"specular", found->second.first, settings.c_str(), alpha};
    const double error = by_quadrature(test, surface_of(test), std::stod(n_v)) - std::stod(albedo);
    const bool creased = model.starts_with("cook");
    EXPECT_LE(std::fabs(error), std::stod(n_v) >= 0.2 ? (creased ? 3e-3 : 1.5e-3) : (creased ? 2.5e-2 : 3e-3))
        << model << " " << settings << " at " << n_v;
    ++rows;
  }
  EXPECT_EQ(rows, 60);
}

/// Shades a made-up scene through the program on the twin and reads what it wrote.
Channels shade(const MadeUpGBuffer& made, const std::string& rig, const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  write_gbuffer(folder / "in.exr", made);
  std::vector<std::string> arguments{"shade",  (folder / "in.exr").string(), "--lights", "-", "-o", (folder / "out.exr").string(), "--device", "twin",
                                     "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_program(arguments, rig);
  EXPECT_EQ(run.code, 0) << run.err;
  return run.code == 0 ? read_channels(folder / "out.exr") : Channels{};
}

MadeUpGBuffer coloured_scene() {
  MadeUpGBuffer made;
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic"});
  return made;
}

TEST(Ambient, LambertUnderRadianceIsAlbedoTimesIt) {
  const MadeUpGBuffer made = coloured_scene();
  const Channels image = shade(made, R"({"relume": 1, "lights": [{"type": "ambient", "intensity": [0.5, 2, 3]}]})", {"--specular", "none"});
  ASSERT_FALSE(image.empty());
  for (int i = 0; i < 64 * 64; ++i) {
    const ScenePixel pixel = scene_at(made, i % 64, i / 64);
    ASSERT_EQ(image.at("R")[std::size_t(i)], float(pixel.albedo.x) * 0.5f);
    ASSERT_EQ(image.at("G")[std::size_t(i)], float(pixel.albedo.y) * 2);
    ASSERT_EQ(image.at("B")[std::size_t(i)], float(pixel.albedo.z) * 3);
  }
}

const char* const three_lights = R"({"relume": 1, "lights": [
    {"type": "point", "name": "key", "position": [2, 3, 4], "intensity": [40, 38, 35]},
    {"type": "directional", "name": "sun", "direction": [1, -1, -1], "intensity": [1, 1, 2]},
    {"type": "ambient", "fraction": 0.01}]})";

/// Irradiance of the two lights above.
double irradiance_of(const ScenePixel& pixel, double point, double sun) {
  const glm::dvec3 to_key = glm::dvec3(2, 3, 4) - pixel.position, to_sun = glm::normalize(glm::dvec3(-1, 1, 1));
  const double d = glm::length(to_key);
  return point / (d * d) * std::max(0.0, glm::dot(pixel.normal, to_key) / d) + sun * std::max(0.0, glm::dot(pixel.normal, to_sun));
}

TEST(Ambient, FractionIsOfTheMeanDirectIrradiance) {
  const MadeUpGBuffer made = coloured_scene();
  const Channels image = shade(made, three_lights, {"--specular", "none", "--layers", "ambient"});
  ASSERT_FALSE(image.empty());
  double red = 0, blue = 0;
  int surface = 0;
  for (int i = 0; i < 64 * 64; ++i) {
    const ScenePixel pixel = scene_at(made, i % 64, i / 64);
    if (pixel.id == 0) continue;
    ++surface;
    red += irradiance_of(pixel, 40, 1);
    blue += irradiance_of(pixel, 35, 2);
  }
  for (std::size_t i = 0; i < 64 * 64; ++i) {
    const ScenePixel pixel = scene_at(made, int(i) % 64, int(i) / 64);
    // A mean irradiance E from everywhere is a radiance of E/pi, of which Lambert reflects albedo times.
    const double r = pixel.albedo.x * 0.01 * red / surface / M_PI, b = pixel.albedo.z * 0.01 * blue / surface / M_PI;
    ASSERT_NEAR(image.at("ambient.R")[i], r, 1e-5 * r);
    ASSERT_NEAR(image.at("ambient.B")[i], b, 1e-5 * b);
  }
}

TEST(Ambient, LayersAddUp) {
  const Channels image = shade(coloured_scene(), three_lights, {"--layers", "diffuse,specular,ambient,lights"});
  ASSERT_FALSE(image.empty());
  int lit = 0;
  for (const std::string c : {"R", "G", "B"})
    for (std::size_t i = 0; i < 64 * 64; ++i) {
      const float total = image.at(c)[i], ambient = image.at("ambient." + c)[i];
      ASSERT_EQ(total, (image.at("diffuse." + c)[i] + image.at("specular." + c)[i]) + ambient);
      ASSERT_NEAR(total, double(image.at("light.key." + c)[i]) + image.at("light.sun." + c)[i] + ambient, 1e-6 * total);
      lit += total > 0 && ambient > 0 && ambient < total;
    }
  EXPECT_GT(lit, 1000);
}

}  // namespace
}  // namespace relume
