// Coverage and ids of anti-aliased layers.
#include "gbuffer/edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "gbuffer/filtered_layers.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/layer_values.h"

namespace relume {
namespace {

constexpr int reach = 3;                 // pixels: filters rarely reach further than 2
constexpr double covers_nothing = 1e-4;  // gaussian tails leak 1e-11 into their surroundings

/// The layers that tell, over the window and its surroundings.
struct Neighbourhood {
  Window window;
  std::vector<float> normals, ids, alpha;  // ids and alpha: empty where the file has none

  Neighbourhood(const ExrFile& file, const Reading& reading, const Window& asked) : window(grown(asked, reach, reading.data_window)) {
    const auto values = [&](const char* role) {
      const auto layer = reading.roles.find(role);
      return layer == reading.roles.end() ? std::vector<float>() : layer_values(file, layer->second, window);
    };
    normals = values("normal"), ids = values("ids"), alpha = values("coverage");
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      const glm::dvec3 decoded = decoded_normal(reading, {normals[i], normals[i + 1], normals[i + 2]});
      for (int c = 0; c < 3; ++c) normals[i + std::size_t(c)] = float(decoded[c]);
    }
  }

  std::size_t index(int x, int y) const { return std::size_t(y - window.min_y) * std::size_t(window.width()) + std::size_t(x - window.min_x); }
  bool inside(int x, int y) const { return x >= window.min_x && x < window.max_x && y >= window.min_y && y < window.max_y; }
  glm::dvec3 normal(std::size_t i) const {
    if (normals.empty()) return {0, 0, 1};  // without normals, alpha and ids alone tell
    return {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
  }

  bool empty(std::size_t i) const { return !(glm::length(normal(i)) >= covers_nothing); }

  /// One surface alone: a mean of several has a short normal or a broken id.
  bool unmixed(std::size_t i) const {
    if (!(std::abs(glm::length(normal(i)) - 1) < 0.01)) return false;
    if (!alpha.empty() && alpha[i] < 0.999f) return false;
    return ids.empty() || whole_number(ids[i]);
  }
};

struct Pixel {
  int x, y;
};

struct Surroundings {
  std::optional<std::size_t> like;  ///< the unmixed pixel that it belongs with
  bool background = false;          ///< some pixel near shows no surface
};

Surroundings around(const Neighbourhood& n, Pixel at) {
  const glm::dvec3 own = n.normal(n.index(at.x, at.y)), direction = own / std::max(glm::length(own), 1e-30);
  Surroundings result;
  double best = 1e300;
  for (int y = at.y - reach; y <= at.y + reach; ++y) {
    for (int x = at.x - reach; x <= at.x + reach; ++x) {
      if (!n.inside(x, y)) continue;
      const std::size_t i = n.index(x, y);
      result.background |= n.empty(i);
      const int away = (x - at.x) * (x - at.x) + (y - at.y) * (y - at.y);
      if (away > reach * reach || !n.unmixed(i)) continue;
      // A right angle between normals counts as much as 3 pixels of distance.
      const double score = away + 9 * (1 - glm::dot(direction, glm::normalize(n.normal(i))));
      if (score < best) best = score, result.like = i;
    }
  }
  return result;
}

double estimated_coverage(const Neighbourhood& n, std::size_t i, const Surroundings& near) {
  if (!near.background) return 1;
  const double length = std::min(1.0, glm::length(n.normal(i)));
  if (n.ids.empty() || !near.like || !(n.ids[*near.like] > 0)) return length;
  const double share = n.ids[i] / std::round(n.ids[*near.like]);
  return std::abs(share - length) < 0.1 ? std::min(1.0, share) : length;  // a third object in the mix makes the share a coincidence
}

std::uint32_t whole(double id) { return id > 0 && id < 4294967295.0 ? std::uint32_t(std::llround(id)) : 0; }

void mend(const Neighbourhood& n, Pixel at, std::size_t out, Edges& edges) {
  const std::size_t i = n.index(at.x, at.y);
  const double alpha = n.alpha.empty() ? 1 : n.alpha[i];
  if (n.empty(i) || n.unmixed(i)) {
    edges.coverage[out] = n.empty(i) ? 0 : float(alpha);
    if (!n.ids.empty()) edges.ids[out] = whole(n.ids[i]);
    return;
  }
  const Surroundings near = around(n, at);
  const double coverage = n.alpha.empty() ? estimated_coverage(n, i, near) : std::clamp(alpha, 0.0, 1.0);
  edges.coverage[out] = coverage < covers_nothing ? 0 : float(coverage);
  if (n.ids.empty()) return;
  const double alone = whole_number(n.ids[i]) && n.ids[i] > 0.5f ? n.ids[i] : n.ids[i] / std::max(coverage, covers_nothing);
  edges.ids[out] = whole(near.like ? n.ids[*near.like] : alone);
}

}  // namespace

Edges mend_edges(const ExrFile& file, const Reading& reading, const Window& window) {
  const Neighbourhood neighbourhood(file, reading, window);
  Edges edges{std::vector<float>(std::size_t(window.pixels())), {}};
  if (!neighbourhood.ids.empty()) edges.ids.resize(std::size_t(window.pixels()));
  tbb::parallel_for(window.min_y, window.max_y, [&](int y) {
    std::size_t out = std::size_t(y - window.min_y) * std::size_t(window.width());
    for (int x = window.min_x; x < window.max_x; ++x) mend(neighbourhood, {x, y}, out++, edges);
  });
  return edges;
}

}  // namespace relume
