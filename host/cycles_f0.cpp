// GlossCol = metallic M(base) + (1 - metallic) D(f0) and DiffCol = base (1 - metallic)(1 - D(f0)) per channel, with M and D of host/cycles_albedo:
// six numbers for five unknowns (research: blender-truth, "Only roughness and GlossCol").
#include "host/cycles_f0.h"

#include <algorithm>
#include <cmath>

#include "host/cycles_albedo.h"

namespace relume {

namespace {

using Rgb = std::array<double, 3>;

constexpr double usual_f0 = 0.04;       // specular level 1/2 at ior 1.5
constexpr double brightest_f0 = 0.16;   // where a search for f0 ends: ior 2.3 or specular level 2
constexpr double storage_error = 5e-4;  // of a half float, relative

/// What a file holds, made numbers from 0 to 1.
Rgb reflectances(const Rgb& c) {
  Rgb r;
  for (int i = 0; i < 3; ++i) r[i] = c[i] > 0 ? std::min(c[i], 1.0) : 0;  // NaN counts as 0
  return r;
}

double largest(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }
double smallest(const Rgb& c) { return std::min({c[0], c[1], c[2]}); }

/// Whether the channels differ by no more than this share.
bool grey(const Rgb& c, double share) { return largest(c) - smallest(c) <= share * largest(c); }

/// x in low..high with f(x) = target for an f that grows, by false position with the Illinois rule; the nearer end where there is none.
template <typename Function>
double solve_growing(const Function& f, double target, double low, double high) {
  double below = f(low) - target, above = f(high) - target;
  if (!(below < 0)) return low;
  if (!(above > 0)) return high;
  int last = 0;
  double x = low;
  for (int step = 0; step < 20; ++step) {
    x = (low * above - high * below) / (above - below);
    const double y = f(x) - target;
    if (std::abs(y) <= 1e-7 * target) break;
    if (y < 0) {
      low = x, below = y;
      if (last < 0) above *= 0.5;
      last = -1;
    } else {
      high = x, above = y;
      if (last > 0) below *= 0.5;
      last = 1;
    }
  }
  return x;
}

CyclesSurface surface(const Rgb& base, double metallic, double f0) { return {base, metallic, 0.5 * f0 / usual_f0}; }

CyclesSurface dielectric(double f0) { return surface({0, 0, 0}, 0, f0); }  // its base colour is in DiffCol alone

/// The least f0 with this albedo: at grazing angles a high index reflects less again.
double dielectric_f0(const CyclesAlbedo& albedo, double target) {
  constexpr int steps = 8;
  double low = 0;
  for (int i = 1; i <= steps; ++i) {
    const double high = brightest_f0 * i * i / (steps * steps);
    if (albedo.dielectric(high) >= target) return solve_growing([&](double x) { return albedo.dielectric(x); }, target, low, high);
    low = high;
  }
  return brightest_f0;
}

CyclesSurface metal(const CyclesAlbedo& albedo, const Rgb& glossy) {
  Rgb base;
  for (int c = 0; c < 3; ++c) base[c] = solve_growing([&](double b) { return albedo.metal(b); }, glossy[c], 0, 1);
  return surface(base, 1, usual_f0);
}

/// The two unknowns from which the rest follows.
struct Guess {
  double metallic, f0;
};

/// The base colour that leaves this DiffCol.
Rgb base_of(const CyclesAlbedo& albedo, const Guess& g, const Rgb& diffuse) {
  const double share = std::max(1e-6, (1 - g.metallic) * (1 - albedo.dielectric(g.f0)));
  Rgb base;
  for (int c = 0; c < 3; ++c) base[c] = std::clamp(diffuse[c] / share, 0.0, 1.0);
  return base;
}

/// GlossCol's errors in units of its rounding, and the distance of f0 from the usual one: weak knowledge, which decides only where colours do not.
std::array<double, 4> misfit(const CyclesAlbedo& albedo, const Guess& g, const Rgb& glossy, const Rgb& diffuse) {
  const Rgb base = base_of(albedo, g, diffuse);
  const double d = albedo.dielectric(g.f0);
  std::array<double, 4> errors;
  for (int c = 0; c < 3; ++c) {
    errors[c] = (g.metallic * albedo.metal(base[c]) + (1 - g.metallic) * d - glossy[c]) / (storage_error * largest(glossy));
  }
  errors[3] = (g.f0 - usual_f0) / 0.01;
  return errors;
}

double squares(const std::array<double, 4>& e) { return e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]; }

/// One step of Levenberg and Marquardt: the guess that the linearised misfit wants.
Guess improved(const CyclesAlbedo& albedo, const Guess& g, const Rgb& glossy, const Rgb& diffuse, double damping) {
  constexpr double h = 1e-5;
  const auto e = misfit(albedo, g, glossy, diffuse), em = misfit(albedo, {g.metallic + h, g.f0}, glossy, diffuse),
             ef = misfit(albedo, {g.metallic, g.f0 + h}, glossy, diffuse);
  double mm = 0, mf = 0, ff = 0, me = 0, fe = 0;
  for (int i = 0; i < 4; ++i) {
    const double dm = (em[i] - e[i]) / h, df = (ef[i] - e[i]) / h;
    mm += dm * dm, mf += dm * df, ff += df * df, me += dm * e[i], fe += df * e[i];
  }
  mm *= 1 + damping, ff *= 1 + damping;
  const double determinant = mm * ff - mf * mf;
  if (!(determinant > 0)) return g;
  return {std::clamp(g.metallic - (ff * me - mf * fe) / determinant, 0.0, 0.999),
          std::clamp(g.f0 - (mm * fe - mf * me) / determinant, 0.0, brightest_f0)};
}

struct Fit {
  Guess guess;
  double error;
};

Fit fitted(const CyclesAlbedo& albedo, Guess g, const Rgb& glossy, const Rgb& diffuse) {
  double error = squares(misfit(albedo, g, glossy, diffuse)), damping = 1e-3;
  for (int step = 0; step < 40 && damping < 1e8; ++step) {
    const Guess next = improved(albedo, g, glossy, diffuse, damping);
    const double next_error = squares(misfit(albedo, next, glossy, diffuse));
    if (next_error < error) {
      const bool settled = error - next_error < 1e-3 && damping < 1;
      g = next, error = next_error, damping *= 0.1;
      if (settled) break;
    } else {
      damping *= 10;
    }
  }
  return {g, error};
}

CyclesSurface partly_metal(const CyclesAlbedo& albedo, const Rgb& glossy, const Rgb& diffuse) {
  // Neglecting the dielectric: glossy = metallic base and diffuse = (1 - metallic) base (1 - D).
  const double d = albedo.dielectric(usual_f0), grown = diffuse[0] + diffuse[1] + diffuse[2], shine = glossy[0] + glossy[1] + glossy[2] - 3 * d;
  const double likely = std::clamp(shine / (shine + grown / (1 - d)), 0.01, 0.99);
  Fit best{{likely, 0}, INFINITY};
  for (const double metallic : {likely, 0.9, 0.1}) {
    const Fit fit = fitted(albedo, {metallic, std::min(usual_f0, dielectric_f0(albedo, smallest(glossy)))}, glossy, diffuse);
    if (fit.error < best.error) best = fit;
    if (best.error < 30) break;  // no more than roundings and an unusual specular level
  }
  return surface(base_of(albedo, best.guess, diffuse), best.guess.metallic, best.guess.f0);
}

}  // namespace

CyclesSurface solve_cycles_surface(const Rgb& glossy_albedo, const Rgb& diffuse_albedo, double roughness, double n_v, bool multi_ggx) {
  const Rgb glossy = reflectances(glossy_albedo), diffuse = reflectances(diffuse_albedo);
  if (!(largest(glossy) > 0)) return dielectric(0);
  const CyclesAlbedo albedo(roughness, n_v, multi_ggx);
  if (grey(glossy, 6 * storage_error)) {
    const double mean = (glossy[0] + glossy[1] + glossy[2]) / 3, f0 = dielectric_f0(albedo, mean);
    const bool coloured = largest(diffuse) > 0 && !grey(diffuse, 0.05);  // a metal of that colour would show it
    const bool possible = std::abs(albedo.dielectric(f0) - mean) <= 6 * storage_error * mean;
    if (possible && (coloured || f0 <= 2.1 * usual_f0)) return dielectric(f0);
  }
  if (largest(diffuse) <= 2e-3 * largest(glossy)) return metal(albedo, glossy);  // all but a five-hundredth
  return partly_metal(albedo, glossy, diffuse);
}

}  // namespace relume
