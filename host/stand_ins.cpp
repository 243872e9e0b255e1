// find_stand_ins: one light at the centroid matches moments of degree 0 and 1. Four at c + sqrt(3) A v_i, where A A^T is the lights' covariance and
// v_i the corners of a regular tetrahedron in the unit sphere, match those of degree 2 as well, because sum v_i = 0 and sum v_i v_i^T = 4/3 I.
#include "host/stand_ins.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace relume {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Fewer lights than these are met themselves rather than four others.
constexpr std::size_t fewest_for_four = 6;
/// Centroids nearer than this share of the radius are one: what it changes is far below the margin of the bounds.
constexpr double same_place = 1e-5;

struct WeighedPoint {
  Vector3d at, intensity;
};

Vector3d vector_of(const float* v) { return {v[0], v[1], v[2]}; }

LightRecord record_of(const WeighedPoint& point) {
  LightRecord r{};
  for (int c = 0; c < 3; ++c) r.position[c] = float(point.at[c]), r.intensity[c] = float(point.intensity[c]);
  r.falloff = FALLOFF_inverse_square;
  r.reach = std::numeric_limits<float>::infinity();
  return r;
}

Vector3d centroid(const std::vector<WeighedPoint>& points, const Vector3d& weights_of_channels, const Vector3d& otherwise) {
  Vector3d sum = Vector3d::Zero();
  double total = 0;
  for (const WeighedPoint& point : points) {
    const double weight = point.intensity.dot(weights_of_channels);
    sum += weight * point.at, total += weight;
  }
  return total > 0 ? Vector3d(sum / total) : otherwise;
}

/// What the moments of channel c about `centre` differ by. Third moments and the second's trace are bounded by their sums.
void compare(const std::vector<WeighedPoint>& lights, const std::vector<WeighedPoint>& others, int c, const Vector3d& centre, StandIns& made) {
  Matrix3d moments[2] = {Matrix3d::Zero(), Matrix3d::Zero()};
  double sum = 0, second = 0, third = 0;
  for (const auto* points : {&lights, &others})
    for (const WeighedPoint& point : *points) {
      const Vector3d d = point.at - centre;
      const double weight = point.intensity[c];
      moments[points == &lights ? 0 : 1] += weight * d * d.transpose();
      sum += 0.5 * weight;
      second += weight * d.squaredNorm();
      third += weight * d.squaredNorm() * d.norm();
    }
  Matrix3d difference = moments[0] - moments[1];
  difference -= difference.trace() / 3 * Matrix3d::Identity();
  made.second[c] = float(second), made.third[c] = float(third), made.uneven[c] = float(difference.norm());
  made.width[c] = float(std::sqrt(sum * std::max(moments[0].norm(), moments[1].norm())));  // the norm is no less than the largest eigenvalue
}

/// In the centroid of each channel; in the common one where they coincide.
std::vector<WeighedPoint> find_one(const std::vector<WeighedPoint>& lights, const Vector3d& centre, double radius, const Vector3d& sum,
                                   StandIns& made) {
  Vector3d centres[3];
  bool coincide = true;
  for (int c = 0; c < 3; ++c) {
    centres[c] = centroid(lights, Vector3d::Unit(c), centre);
    coincide &= (centres[c] - centre).norm() <= same_place * radius;
  }
  std::vector<WeighedPoint> points;
  if (coincide) {
    points.push_back({centre, sum});
  } else {
    for (int c = 0; c < 3; ++c)
      if (sum[c] > 0) points.push_back({centres[c], sum[c] * Vector3d::Unit(c)});
  }
  for (int c = 0; c < 3; ++c) compare(lights, points, c, coincide ? centre : centres[c], made);
  return points;
}

/// Corners in the lights' own axes, with intensities (1 + 3 v_i.y)/4 of each channel's, where A sqrt(3) y leads to its centroid. Nothing where that
/// needs intensities below 0.
std::vector<WeighedPoint> find_four(const std::vector<WeighedPoint>& lights, const Vector3d& centre, double radius, const Vector3d& sum) {
  Matrix3d covariance = Matrix3d::Zero();
  for (const WeighedPoint& light : lights) covariance += light.intensity.sum() * (light.at - centre) * (light.at - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance / sum.sum());
  const Matrix3d reach = axes.eigenvectors() * (3 * axes.eigenvalues().cwiseMax(0)).cwiseSqrt().asDiagonal();
  const double s = 1 / std::sqrt(3.0);
  const Vector3d corners[] = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  std::vector<WeighedPoint> points;
  for (const Vector3d& corner : corners) points.push_back({centre + reach * corner, Vector3d::Zero()});
  for (int c = 0; c < 3; ++c) {
    const Vector3d offset = centroid(lights, Vector3d::Unit(c), centre) - centre;
    Vector3d y = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      if (const double length = reach.col(k).norm(); length > same_place * radius) y[k] = reach.col(k).dot(offset) / (length * length);
    if ((reach * y - offset).norm() > same_place * radius) return {};
    for (std::size_t i = 0; i < 4; ++i) {
      points[i].intensity[c] = sum[c] * (1 + 3 * corners[i].dot(y)) / 4;
      if (points[i].intensity[c] < 0) return {};
    }
  }
  return points;
}

/// Of the ball that holds these too.
double radius_with(double radius, const Vector3d& centre, const std::vector<WeighedPoint>& points) {
  for (const WeighedPoint& point : points) radius = std::max(radius, (point.at - centre).norm());
  return radius;
}

}  // namespace

std::vector<LightRecord> find_stand_ins(LightCluster& cluster, std::span<const LightRecord> records, std::span<const int> numbers) {
  std::vector<WeighedPoint> lights, made;
  Vector3d sum = Vector3d::Zero(), middle = Vector3d::Zero();
  for (const int k : numbers) {
    const LightRecord& r = records[std::size_t(k)];
    lights.push_back({vector_of(r.position), vector_of(r.intensity)});
    sum += lights.back().intensity, middle += lights.back().at / double(numbers.size());
  }
  const Vector3d centre = centroid(lights, Vector3d::Ones(), middle);
  double radius = radius_with(0, centre, lights);
  std::vector<LightRecord> stand_ins;
  const auto keep = [&](const std::vector<WeighedPoint>& points, StandIns& kept) {
    // No fewer than the lights: they would gain nothing.
    kept.count = points.size() < lights.size() ? int(points.size()) : 0;
    if (kept.count == 0) return;
    radius = radius_with(radius, centre, points);
    for (const WeighedPoint& point : points) stand_ins.push_back(record_of(point));
  };
  keep(find_one(lights, centre, radius, sum, cluster.one), cluster.one);
  if (lights.size() >= fewest_for_four && sum.sum() > 0) {
    const std::vector<WeighedPoint> points = find_four(lights, centre, radius, sum);
    for (int c = 0; c < 3 && !points.empty(); ++c) compare(lights, points, c, centre, cluster.four);
    keep(points, cluster.four);
  }
  for (int c = 0; c < 3; ++c) cluster.centre[c] = float(centre[c]), cluster.intensity[c] = float(sum[c]);
  cluster.radius = float(radius * (1 + same_place));
  return stand_ins;
}

}  // namespace relume
