// greatest_ks: what a lobe of coefficient 1 reflects straight ahead, over the most that it reflects in all.
#include "lab/greatest_ks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/directional_albedo.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;

struct Form {
  const char* lobe;
  const char* title;
  double (*formula)(double e);
};

// The greatest albedo is at normal incidence, where R_v.l is cos and n.h is cos of half the angle of l.
constexpr Form forms[] = {
    {"phong", "Phong, f_r = Ks (R_v.l)^e", [](double e) { return (e + 2) / (2 * pi); }},
    {"blinn_phong_exact", "Blinn, f_r = Ks (n.h)^e", [](double e) { return (e + 2) * (e + 4) / (8 * pi * (std::exp2(-e / 2) + e)); }},
    {"phong_original", "Phong 1975, f_r n.l = Ks (R_v.l)^e", [](double e) { return (e + 1) / (2 * pi); }},
    {"blinn_phong_original", "Blinn 1977, f_r n.l = Ks (n.h)^e", [](double e) { return (e + 2) / (8 * pi * (1 - std::exp2(-(e + 2) / 2))); }}};

constexpr double exponents[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};
constexpr double views[] = {1, 0.99, 0.9, 0.7, 0.5, 0.3, 0.1, 0.02};

std::string printed(const GreatestKs& k) {
  char text[200];
  std::snprintf(text, sizeof text, "%s,%g,%.9g,%.2g,%.9g\n", k.lobe.c_str(), k.exponent, k.measured, k.error, k.formula);
  return text;
}

}  // namespace

std::vector<GreatestKs> greatest_ks(std::shared_ptr<Device> device) {
  std::vector<GreatestKs> all;
  const DirectionPair straight = facing(1);
  for (const Form& form : forms)
    for (const double e : exponents) {
      const Brdf brdf(form.lobe, {"ks=1", "exponent=" + std::to_string(e)}, device);
      const double peak = brdf.reflectance(std::span(&straight, 1)).front().total().x;
      Albedo greatest{};
      for (const LobeAlbedos& albedos :
           directional_albedos([&](auto pairs) { return brdf.reflectance(pairs); }, views, 1e-6 * peak / form.formula(e)))
        if (albedos.total().value.x > greatest.value.x) greatest = albedos.total();
      all.push_back({form.lobe, e, peak / greatest.value.x, greatest.error.x / greatest.value.x, form.formula(e)});
    }
  return all;
}

Figure ks_figure(const std::vector<GreatestKs>& all) {
  Figure figure;
  figure.width = 900;
  figure.height = 760;
  std::string lines, points, apart;
  int number = 0;
  for (const Form& form : forms) {
    const std::string block = "$form" + std::to_string(number++), type = " lt " + std::to_string(number);
    figure.data += block + " << END\n";
    for (const GreatestKs& k : all)
      if (k.lobe == form.lobe) {
        char row[120];
        std::snprintf(row, sizeof row, "%g %.9g %.9g %.3g\n", k.exponent, k.measured, k.formula, std::abs(k.measured / k.formula - 1));
        figure.data += row;
      }
    figure.data += "END\n";
    lines += (lines.empty() ? "" : ", ") + block + " using 1:3 with lines" + type + " title " + quoted(form.title);
    points += ", " + block + " using 1:2 with points" + type + " notitle";
    apart += (apart.empty() ? "" : ", ") + block + " using 1:4 with linespoints" + type + " notitle";
  }
  figure.commands =
      "set multiplot\nset lmargin 12\nset logscale xy\nset xrange [0.9:12000]\nset origin 0,0.36\nset size 1,0.64\nset key left top Left reverse\n"
      "set title 'The greatest Ks(e) with which no more is reflected than arrives: lines the formula, points the kernels'\nset ylabel 'Ks(e), 1/sr'\n"
      "plot " +
      lines + points +
      "\nset origin 0,0\nset size 1,0.36\nunset title\nset xlabel 'exponent e'\nset ylabel 'relative difference'\nset format y '%.0e'\n"
      "set yrange [1e-10:1e-4]\nplot " +
      apart + "\nunset multiplot\n";
  return figure;
}

std::string ks_csv(const std::vector<GreatestKs>& all) {
  std::string text = "lobe,exponent,measured,error,formula\n";
  for (const GreatestKs& k : all) text += printed(k);
  return text;
}

}  // namespace relume
