// Connected pure pixels of one surface, and the plane through each of their components.
#include "gbuffer/surroundings.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

#include "gbuffer/mixtures.h"

namespace relume {
namespace {

using Eigen::ArrayXd;
constexpr int reach = FilteredLayers::reach, side = 2 * reach + 1;
constexpr std::size_t fewest_pixels = 3;  // that determine a plane

struct Member {
  std::size_t pixel;
  double dx, dy;  ///< from the mixed pixel
};

struct Group {
  std::vector<Member> members;
  double nearest = 1e300;  ///< squared
};

/// Finds the groups one after another; `seen` are pixels that belong to one.
class Flood {
 public:
  Flood(const FilteredLayers& layers, int x, int y) : layers_(layers), left_(x - reach), top_(y - reach) {}

  std::vector<Group> groups() {
    std::vector<Group> found;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (takes(x, y)) found.push_back(from(x, y));
    std::erase_if(found, [](const Group& g) { return g.members.size() < fewest_pixels; });
    std::stable_sort(found.begin(), found.end(), [](const Group& a, const Group& b) { return a.nearest < b.nearest; });
    if (found.size() > Mixtures::most_surfaces) found.resize(Mixtures::most_surfaces);
    return found;
  }

 private:
  std::size_t index(int x, int y) const { return layers_.index(left_ + x, top_ + y); }
  bool takes(int x, int y) const {
    return x >= 0 && y >= 0 && x < side && y < side && !seen_[std::size_t(y * side + x)] && layers_.inside(left_ + x, top_ + y) &&
           layers_.pure(index(x, y));
  }

  Group from(int x0, int y0) {
    Group group;
    std::vector<std::array<int, 2>> open{{x0, y0}};
    seen_[std::size_t(y0 * side + x0)] = true;
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      const double dx = x - reach, dy = y - reach;
      group.members.push_back({index(x, y), dx, dy});
      group.nearest = std::min(group.nearest, dx * dx + dy * dy);
      for (const auto& [u, v] : {std::array{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
        if (!takes(u, v) || !layers_.one_surface(index(x, y), index(u, v))) continue;
        seen_[std::size_t(v * side + u)] = true;
        open.push_back({u, v});
      }
    }
    return group;
  }

  const FilteredLayers& layers_;
  const int left_, top_;
  std::array<bool, std::size_t(side* side)> seen_{};
};

ArrayXd value_of(const FilteredLayers& layers, std::size_t pixel) {
  return Eigen::Map<const Eigen::ArrayXf>(layers.value(pixel), layers.components()).cast<double>();
}

/// Weighted moments of a group's places and values.
struct Moments {
  double total = 0;
  Eigen::Vector2d centre{0, 0};
  ArrayXd mean;
};

double weight_of(const Member& m) {
  constexpr double spread = 2;  // pixels: what is nearer tells more, but one row alone tells no slope
  return std::exp(-(m.dx * m.dx + m.dy * m.dy) / (2 * spread * spread));
}

Moments moments_of(const FilteredLayers& layers, const Group& group) {
  Moments m{0, {0, 0}, ArrayXd::Zero(layers.components())};
  for (const Member& member : group.members) {
    const double w = weight_of(member);
    m.total += w;
    m.centre += w * Eigen::Vector2d(member.dx, member.dy);
    m.mean += w * value_of(layers, member.pixel);
  }
  m.centre /= m.total;
  m.mean /= m.total;
  return m;
}

void make_unit(const FilteredLayers& layers, ArrayXd& value) {
  for (const char* role : {"normal", "base_normal"})
    if (const auto* layer = layers.layer(role)) {
      const double length = value.segment(layer->first, 3).matrix().norm();
      if (length > 0) value.segment(layer->first, 3) /= length;
    }
}

/// Noise of the stored numbers, squared.
ArrayXd noise_of(const FilteredLayers& layers, const ArrayXd& value) {
  ArrayXd noise(layers.components());
  for (const auto& layer : layers.layers()) {
    const double scale = layer.relative ? value.segment(layer.first, layer.count).abs().maxCoeff() : 1;
    noise.segment(layer.first, layer.count) = std::pow(layer.resolution * scale, 2);
  }
  return noise;
}

/// The plane continued to the pixel. It is as unsure as the group is uneven, the more the farther the pixel, and as a part of a pixel
/// may lie off its centre.
Surface continued(const FilteredLayers& layers, const Group& group) {
  constexpr double ridge = 0.02;       // pixels squared: a single row of pixels has no slope across
  constexpr double off_centre = 0.29;  // pixels: the standard deviation of a point in a pixel
  const Moments m = moments_of(layers, group);
  Eigen::Matrix2d spread = ridge * Eigen::Matrix2d::Identity();
  Eigen::MatrixX2d along = Eigen::MatrixX2d::Zero(layers.components(), 2);
  for (const Member& member : group.members) {
    const double w = weight_of(member) / m.total;
    const Eigen::Vector2d place = Eigen::Vector2d(member.dx, member.dy) - m.centre;
    spread += w * place * place.transpose();
    along += w * (value_of(layers, member.pixel) - m.mean).matrix() * place.transpose();
  }
  const Eigen::Matrix2d inverse = spread.inverse();
  const Eigen::MatrixX2d slope = along * inverse;
  ArrayXd uneven = ArrayXd::Zero(layers.components());
  for (const Member& member : group.members) {
    const Eigen::Vector2d place = Eigen::Vector2d(member.dx, member.dy) - m.centre;
    uneven += weight_of(member) / m.total * (value_of(layers, member.pixel) - m.mean - (slope * place).array()).square();
  }
  const double far = 1 + m.centre.dot(inverse * m.centre);
  Surface surface;
  surface.value = m.mean - (slope * m.centre).array();
  surface.variance = far * uneven + off_centre * off_centre * slope.rowwise().squaredNorm().array();
  make_unit(layers, surface.value);
  surface.variance += noise_of(layers, surface.value);
  if (const auto* ids = layers.layer("ids"))
    surface.id = std::uint32_t(std::llround(std::max(0.0f, layers.value(group.members[0].pixel)[ids->first])));
  return surface;
}

}  // namespace

Surroundings surroundings(const FilteredLayers& layers, int x, int y) {
  Surroundings result;
  for (const Group& group : Flood(layers, x, y).groups()) result.surfaces.push_back(continued(layers, group));
  const auto* alpha = layers.layer("coverage");
  for (int v = y - reach; v <= y + reach; ++v)
    for (int u = x - reach; u <= x + reach; ++u) {
      if (!layers.inside(u, v) || !layers.empty(layers.index(u, v))) continue;
      result.background = true;
      if (alpha && layers.value(layers.index(u, v))[alpha->first] > 0.5f) result.alpha_tells = false;
    }
  return result;
}

}  // namespace relume
