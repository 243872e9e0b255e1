// A mixed pixel x is modelled as x = sum of w_k s_k: surfaces s_k as their pure neighbours tell, with a variance that says how well; weights w_k by
// least squares; then the s_k are corrected so that they do make up x (the posterior mean of a linear observation of Gaussians).
#include "gbuffer/mixtures.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "gbuffer/surroundings.h"

namespace relume {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

/// What is asked of the weights: rows of A w = b, each divided by its standard deviation.
struct Equations {
  MatrixXd a;
  VectorXd b;
};

struct Weights {
  VectorXd w;
  double cost = 1e300;
};

/// What weights of 1 would have to make of the layer: the equation is sum of w_k (s_k - of_surface) = of_pixel.
struct Target {
  ArrayXd of_surface, of_pixel;
};

Target target_of(const FilteredLayers::Layer& layer, const ArrayXd& x, const ArrayXd& s) {
  using Mean = FilteredLayers::Mean;
  const ArrayXd stored = x.segment(layer.first, layer.count), nothing = ArrayXd::Zero(layer.count);
  if (layer.mean == Mean::over_hits) return {stored, nothing};
  if (layer.mean == Mean::direction) return {stored * (stored * s.segment(layer.first, layer.count)).sum(), nothing};
  return {nothing, stored};
}

Equations equations_of(const FilteredLayers& layers, const Surroundings& near, const ArrayXd& x) {
  const int count = int(near.surfaces.size());
  Equations e{MatrixXd::Zero(layers.components(), count), VectorXd::Zero(layers.components())};
  for (const auto& layer : layers.layers()) {
    if (layer.mean == FilteredLayers::Mean::none || (layer.role == "coverage" && !near.alpha_tells)) continue;
    if (layer.role == "ids" && whole_number(x[layer.first])) continue;  // of one object, or not averaged
    ArrayXd variance = ArrayXd::Zero(layer.count);
    for (const Surface& s : near.surfaces) variance = variance.max(s.variance.segment(layer.first, layer.count));
    const ArrayXd scale = variance.rsqrt();
    for (int k = 0; k < count; ++k) {
      const ArrayXd& s = near.surfaces[std::size_t(k)].value;
      const Target target = target_of(layer, x, s);
      e.a.col(k).segment(layer.first, layer.count) = (scale * (s.segment(layer.first, layer.count) - target.of_surface)).matrix();
      e.b.segment(layer.first, layer.count) = (scale * target.of_pixel).matrix();
    }
  }
  return e;
}

/// Least squares over the surfaces of a subset; with `whole` their weights add up to 1.
Weights solve(const Equations& e, unsigned subset, bool whole) {
  constexpr double strict = 1e6;  // stands for an equation without error
  const int count = int(e.a.cols());
  MatrixXd normal = MatrixXd::Identity(count, count);
  VectorXd right = VectorXd::Zero(count);
  for (int i = 0; i < count; ++i) {
    if (!(subset >> i & 1)) continue;
    right[i] = e.a.col(i).dot(e.b) + (whole ? strict : 0);
    for (int j = 0; j < count; ++j)
      if (subset >> j & 1) normal(i, j) = e.a.col(i).dot(e.a.col(j)) + (whole ? strict : 0) + (i == j ? 1e-6 : 0);
  }
  Weights result{normal.ldlt().solve(right), 0};
  constexpr double per_number = 2;  // Akaike: what is free to choose must explain more than chance
  result.cost = (e.a * result.w - e.b).squaredNorm() + per_number * (__builtin_popcount(subset) - (whole ? 1 : 0));
  return result;
}

Weights best_weights(const Equations& e, bool background) {
  Weights best;
  for (unsigned subset = 1; subset < 1u << e.a.cols(); ++subset)
    for (const bool whole : {true, false}) {
      if (!whole && !background) continue;
      const Weights found = solve(e, subset, whole);
      if (found.w.minCoeff() < 0 || found.w.sum() > 1.001 || !(found.cost < best.cost)) continue;
      best = found;
    }
  return best;
}

/// Corrects the surfaces so that the weights make the pixel of them.
void correct(const FilteredLayers& layers, const VectorXd& w, const ArrayXd& x, std::vector<Surface>& surfaces) {
  for (const auto& layer : layers.layers()) {
    if (layer.mean == FilteredLayers::Mean::none) continue;
    const auto part = [&](ArrayXd& a) { return a.segment(layer.first, layer.count); };
    ArrayXd residual = ArrayXd::Zero(layer.count), variance = ArrayXd::Zero(layer.count);
    for (int k = 0; k < w.size(); ++k) {
      Surface& s = surfaces[std::size_t(k)];
      const Target target = target_of(layer, x, s.value);
      if (k == 0) residual = target.of_pixel;
      residual -= w[k] * (part(s.value) - target.of_surface);
      variance += w[k] * w[k] * part(s.variance);
    }
    for (int k = 0; k < w.size(); ++k) part(surfaces[std::size_t(k)].value) += part(surfaces[std::size_t(k)].variance) * (w[k] / variance * residual);
  }
}

/// What is no mean belongs to the surface that the pixel's centre shows.
void take_centre(const FilteredLayers& layers, const VectorXd& w, const ArrayXd& x, std::vector<Surface>& surfaces) {
  const auto* position = layers.layer("position");
  if (!position || position->mean != FilteredLayers::Mean::none) return;
  constexpr double fits = 25;  // five standard deviations
  double best = fits;
  Surface* owner = nullptr;
  for (int k = 0; k < w.size(); ++k) {
    Surface& s = surfaces[std::size_t(k)];
    const auto away = (x - s.value).square() / s.variance;
    const double mean = away.segment(position->first, 3).mean();
    if (w[k] > 0 && mean < best) best = mean, owner = &s;
  }
  if (!owner) return;
  for (const auto& layer : layers.layers())
    if (layer.mean == FilteredLayers::Mean::none) owner->value.segment(layer.first, layer.count) = x.segment(layer.first, layer.count);
}

struct Share {
  double weight;
  Surface surface;
};

constexpr double negligible = 0.01;  // of a pixel

/// The largest first. Empty: the neighbours do not explain the pixel.
std::vector<Share> shares_of(const FilteredLayers& layers, int px, int py) {
  Surroundings near = surroundings(layers, px, py);
  if (near.surfaces.empty()) return {};
  const ArrayXd x = Eigen::Map<const Eigen::ArrayXf>(layers.value(layers.index(px, py)), layers.components()).cast<double>();
  const Equations e = equations_of(layers, near, x);
  const Weights found = best_weights(e, near.background);
  constexpr double too_far = 4;  // mean square: two standard deviations
  if (!(found.cost < too_far * double(layers.components()))) return {};
  correct(layers, found.w, x, near.surfaces);
  take_centre(layers, found.w, x, near.surfaces);
  std::vector<Share> shares;
  double kept = 0;
  for (int k = 0; k < found.w.size(); ++k)
    if (found.w[k] > negligible) shares.push_back({found.w[k], near.surfaces[std::size_t(k)]}), kept += found.w[k];
  for (Share& s : shares) s.weight *= found.w.sum() / kept;
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.weight > b.weight; });
  return shares;
}

void append(const FilteredLayers& layers, std::int64_t pixel, const Share& share, Mixtures& to) {
  to.samples.push_back({pixel, float(share.weight), share.surface.id});
  for (const auto& layer : layers.layers())
    for (int d = layer.first; d < layer.first + layer.count; ++d) {
      const double value = share.surface.value[d];
      to.values.push_back(float(layer.is_signed ? value : std::max(0.0, value)));
    }
}

/// A surface and background need no taking apart where all layers are divided by coverage anyway.
void explain(const FilteredLayers& layers, bool divided_anyway, int x, int y, std::int64_t pixel, Mixtures& to) {
  const std::vector<Share> shares = shares_of(layers, x, y);
  if (shares.size() == 1 && shares[0].weight > 1 - negligible) return;  // curved within the pixel
  ++(shares.empty() ? to.unexplained : shares.size() == 1 ? to.partial : to.apart);
  if (shares.empty() || (shares.size() == 1 && divided_anyway)) return;
  ++to.replaced;
  for (const Share& share : shares) append(layers, pixel, share, to);
}

void append(const Mixtures& row, Mixtures& to) {
  to.samples.insert(to.samples.end(), row.samples.begin(), row.samples.end());
  to.values.insert(to.values.end(), row.values.begin(), row.values.end());
  to.apart += row.apart;
  to.partial += row.partial;
  to.unexplained += row.unexplained;
  to.replaced += row.replaced;
}

}  // namespace

Mixtures find_mixtures(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles) {
  if (!reading.filtered || !reading.roles.contains("position") || !reading.roles.contains("normal")) return {};
  const FilteredLayers layers(file, reading, window, roles);
  std::vector<Mixtures> rows(std::size_t(window.height()));
  tbb::parallel_for(window.min_y, window.max_y, [&](int y) {
    Mixtures& row = rows[std::size_t(y - window.min_y)];
    for (int x = window.min_x; x < window.max_x; ++x) {
      if (!layers.mixed(layers.index(x, y))) continue;
      const std::int64_t pixel = std::int64_t(y - window.min_y) * window.width() + (x - window.min_x);
      explain(layers, reading.position_premultiplied, x, y, pixel, row);
    }
  });
  Mixtures all;
  for (const auto& layer : layers.layers()) {
    all.roles.push_back(layer.role);
    all.firsts.push_back(layer.first);
  }
  all.components = layers.components();
  for (const Mixtures& row : rows) append(row, all);
  return all;
}

}  // namespace relume
