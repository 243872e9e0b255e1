// In which space are normals, and with which axes? In the one where they agree best with the normals of the surface that the positions span.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "gbuffer/layer_frame.h"
#include "gbuffer/solver/surface_normals.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

using glm::dmat3;
using glm::dvec3;

struct Candidate {
  Space space;
  Axes axes;
  double score = 0;               ///< mean cosine between stored and geometric normals, either way round: 1 where all agree
  double facing = 0;              ///< the same with its sign, over pixels: negative where normals point away from the viewer
  std::vector<double> cosines{};  ///< per orientation
};

/// Samples of one orientation: bumps average out within it, and a floor that fills the picture has no more say than the things on it.
struct Orientation {
  std::vector<std::size_t> samples;
  dvec3 geometric{0};
  double weight = 0;  ///< of all
};

/// By cells of a cube around the origin, some 11 degrees wide.
std::vector<Orientation> orientations_of(const std::vector<SurfaceNormal>& samples) {
  constexpr double cells = 4;  // each side of 0
  std::map<std::array<int, 3>, Orientation> by_cell;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const dvec3& n = samples[i].geometric;
    const dvec3 on_cube = glm::round(n * (cells / std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)})));
    Orientation& cell = by_cell[{int(on_cube.x), int(on_cube.y), int(on_cube.z)}];
    cell.samples.push_back(i);
    cell.geometric += n;
  }
  std::vector<Orientation> all;
  double sum = 0;
  for (auto& [key, cell] : by_cell) {
    constexpr std::size_t too_few = 3;  // edges that look even
    if (cell.samples.size() < too_few && by_cell.size() > too_few) continue;
    cell.weight = std::sqrt(double(cell.samples.size()));  // between one vote each and one vote a pixel
    sum += cell.weight;
    cell.geometric = glm::normalize(cell.geometric);
    all.push_back(std::move(cell));
  }
  for (Orientation& o : all) o.weight /= sum;
  return all;
}

/// What the stored normals are in the world, read so.
std::vector<dvec3> in_world(const std::vector<SurfaceNormal>& samples, const Candidate& c, const Camera& camera) {
  const dmat3 world_from_camera(camera.world_from_camera);
  std::vector<dvec3> normals;
  for (const SurfaceNormal& s : samples) {
    const dvec3 ordered = in_axes(c.axes, s.stored);
    const dvec3 seen = c.space == Space::view_ray ? camera_from_view_ray(s.seen) * ordered : ordered;
    normals.push_back(c.space == Space::world ? ordered : glm::normalize(world_from_camera * seen));
  }
  return normals;
}

/// All 48 ways to order and flip three axes, the plainest first: as stored, then by the number of flips, then those that swap.
std::vector<Axes> all_axes() {
  std::vector<Axes> all;
  std::array<int, 3> order{0, 1, 2};
  do
    for (int flips = 0; flips < 8; ++flips) all.push_back({order, {flips & 1 ? -1 : 1, flips & 2 ? -1 : 1, flips & 4 ? -1 : 1}});
  while (std::next_permutation(order.begin(), order.end()));
  const auto oddity = [](const Axes& a) { return 4 * (a.from != Axes{}.from) + (a.sign[0] < 0) + (a.sign[1] < 0) + (a.sign[2] < 0); };
  std::stable_sort(all.begin(), all.end(), [&](const Axes& a, const Axes& b) { return oddity(a) < oddity(b); });
  return all;
}

/// The mean cosine to each orientation, either way round: normals that point away belong to it as well.
std::vector<double> cosines(const std::vector<dvec3>& normals, const std::vector<Orientation>& orientations) {
  std::vector<double> result;
  for (const Orientation& o : orientations) {
    dvec3 mean{0};
    for (const std::size_t i : o.samples) mean += glm::dot(normals[i], o.geometric) < 0 ? -normals[i] : normals[i];
    result.push_back(glm::length(mean) > 0 ? glm::dot(glm::normalize(mean), o.geometric) : 0);
  }
  return result;
}

std::vector<Candidate> scored(const std::vector<SurfaceNormal>& samples, const std::vector<Orientation>& orientations, Space space,
                              const Camera& camera) {
  std::vector<Candidate> candidates;
  for (const Axes& axes : all_axes()) {
    Candidate c{space, axes};
    const std::vector<dvec3> normals = in_world(samples, c, camera);
    c.cosines = cosines(normals, orientations);
    for (std::size_t k = 0; k < orientations.size(); ++k) c.score += orientations[k].weight * c.cosines[k];
    for (std::size_t i = 0; i < samples.size(); ++i) c.facing += glm::dot(normals[i], samples[i].geometric) / double(samples.size());
    candidates.push_back(std::move(c));
  }
  return candidates;
}

/// By how many standard errors one candidate beats another over the orientations.
double advantage(const Candidate& a, const Candidate& b, const std::vector<Orientation>& orientations) {
  double mean = 0, squares = 0;
  for (std::size_t k = 0; k < orientations.size(); ++k) {
    const double gain = a.cosines[k] - b.cosines[k];
    mean += orientations[k].weight * gain;
    squares += orientations[k].weight * gain * gain;
  }
  return mean / std::sqrt(std::max(squares - mean * mean, 1e-12) / double(orientations.size()));
}

constexpr double rounding = 1e-5;  ///< of a mean cosine: normals in half precision leave less

/// A camera that is almost level makes spaces differ by little, which clean normals still show.
bool clearly_better(const Candidate& a, const Candidate& b) {
  constexpr double gain = 0.01, times = 4;
  return a.score > b.score + gain || 1 - b.score > times * (1 - a.score) + rounding;
}

Axes inverted(Axes axes) {
  for (int& sign : axes.sign) sign = -sign;
  return axes;
}

/// Axes and their inversion explain the surfaces alike. Surfaces face their viewer, unless the renderer stores sides as they are.
void face_viewer(Candidate& c, const Reading& reading) {
  const bool as_convention = c.space == reading.normal_space && c.axes == reading.normal_axes;
  constexpr double mostly_away = -0.5;
  if (as_convention && (reading.facing != Facing::as_stored || c.facing > mostly_away)) return;
  if (c.facing >= (c.axes == Axes{} ? mostly_away : 0)) return;  // leaves show either side
  c.axes = inverted(c.axes);
  c.facing = -c.facing;
}

std::string words(const Candidate& c) { return std::string(name_of(c.space)) + (c.axes == Axes{} ? "" : ", axes " + text_of(c.axes)); }

bool allowed(const Candidate& c, const ReadingOptions& options) {
  return (!options.normal_space || *options.normal_space == c.space) && (!options.normal_axes || *options.normal_axes == c.axes);
}

std::vector<Candidate> candidates_of(const std::vector<SurfaceNormal>& samples, const std::vector<Orientation>& orientations, const Asked& asked,
                                     const Reading& reading) {
  std::vector<Space> spaces{reading.normal_space};
  for (const Space space : {Space::world, Space::camera})
    if (space != reading.normal_space) spaces.push_back(space);
  std::vector<Candidate> candidates;
  for (const Space space : spaces)
    for (const Candidate& c : scored(samples, orientations, space, *reading.camera))
      if (allowed(c, asked.options)) candidates.push_back(c);
  if (reading.normal_space == Space::view_ray) return candidates;
  // V-Ray's frame also where another program has dropped its marks: as V-Ray stores it only, since flipped it differs from camera space by little.
  const Candidate view_ray = scored(samples, orientations, Space::view_ray, *reading.camera).front();
  if (allowed(view_ray, asked.options)) candidates.push_back(view_ray);
  return candidates;
}

/// The best that means other normals than the chosen one: a camera that stands straight leaves several words for one thing.
const Candidate* rival_of(const Candidate& chosen, const std::vector<Candidate>& all, const std::vector<SurfaceNormal>& samples,
                          const Camera& camera) {
  const std::vector<dvec3> normals = in_world(samples, chosen, camera);
  const auto differs = [&](const Candidate& c) {
    constexpr double one_degree = 0.99985;  // cosine
    double mean = 0;
    const std::vector<dvec3> others = in_world(samples, c, camera);
    for (std::size_t i = 0; i < normals.size(); ++i) mean += std::abs(glm::dot(normals[i], others[i])) / double(normals.size());
    return mean < one_degree;
  };
  std::vector<const Candidate*> by_score;
  for (const Candidate& c : all) by_score.push_back(&c);
  std::stable_sort(by_score.begin(), by_score.end(), [](const Candidate* a, const Candidate* b) { return a->score > b->score; });
  const auto rival = std::find_if(by_score.begin(), by_score.end(), [&](const Candidate* c) { return differs(*c); });
  return rival == by_score.end() ? nullptr : *rival;
}

}  // namespace

void ask_normal_space(const Asked& asked, Reading& reading) {
  if (!reading.roles.contains("normal") || !reading.camera || (asked.options.normal_space && asked.options.normal_axes)) return;
  const std::vector<SurfaceNormal> samples = surface_normals(asked, reading);
  constexpr std::size_t few = 16;
  if (samples.size() < few) {
    const bool told = reading.convention != "generic";  // by the renderer's ways, or its names
    if (!told)
      reading.verdicts.push_back(
          {"normal space", name_of(reading.normal_space), "too few pixels show an even surface to tell by", "--normal-space, --normal-axes", false});
    return;
  }
  const std::vector<Orientation> orientations = orientations_of(samples);
  const std::vector<Candidate> all = candidates_of(samples, orientations, asked, reading);
  const auto same = [&](const Candidate& c) { return c.space == reading.normal_space && c.axes == reading.normal_axes; };
  const auto before = std::find_if(all.begin(), all.end(), same);
  const Candidate prior = before == all.end() ? all.front() : *before;
  const double top = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.score < b.score; })->score;
  // What bumps and smooth shading move the mean cosine by; less where the best shows none of them.
  const double as_good = std::min(0.003, 2 * (1 - top) + rounding);
  const auto best = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.score > top - as_good; });  // the plainest of the best
  // A reading is overturned only for one that explains much, and beyond chance.
  constexpr double explains = 0.85, beyond_chance = 3;
  const bool overturned = best->score > explains && clearly_better(*best, prior) && advantage(*best, prior, orientations) > beyond_chance;
  Candidate chosen = overturned ? *best : prior;
  if (!asked.options.normal_axes) face_viewer(chosen, reading);
  const Candidate* const rival = rival_of(chosen, all, samples, *reading.camera);
  reading.normal_space = chosen.space;
  reading.normal_axes = chosen.axes;
  const bool either_side = overturned && std::abs(chosen.facing) < 0.5;  // as many normals point away as to the viewer: which are the outer ones?
  reading.verdicts.push_back({"normal space", words(chosen),
                              "mean cosine to the surfaces that the positions span: " + three_digits(chosen.score) +
                                  (rival ? "; next: " + words(*rival) + " " + three_digits(rival->score) : "") +
                                  (chosen.score < explains ? "; bump maps, or a frame of their own" : "") +
                                  (either_side ? "; as many point away from the viewer as towards" : ""),
                              "--normal-space, --normal-axes",
                              chosen.score > explains && !either_side && (!rival || clearly_better(chosen, *rival))});
}

}  // namespace relume
