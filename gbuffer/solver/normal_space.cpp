// In which space are normals, and with which axes? In the one where they agree best with the normals of the surface that the positions span.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gbuffer/layer_frame.h"
#include "gbuffer/solver/surface_normals.h"

namespace relume {
namespace {

using glm::dmat3;
using glm::dvec3;

struct Candidate {
  Space space;
  Axes axes;
  double score = 0;   ///< mean cosine between stored and geometric normals, either way round: 1 where all agree
  double facing = 0;  ///< the same with its sign: negative where normals point away from the viewer
};

/// The geometric normals as a layer of this space would store them.
std::vector<dvec3> in_space(const std::vector<SurfaceNormal>& samples, Space space, const Camera& camera) {
  const dmat3 camera_from_world = glm::transpose(dmat3(camera.world_from_camera));
  std::vector<dvec3> normals;
  for (const SurfaceNormal& s : samples) {
    if (space == Space::world)
      normals.push_back(s.geometric);
    else if (space == Space::camera)
      normals.push_back(camera_from_world * s.geometric);
    else
      normals.push_back(glm::normalize(glm::inverse(camera_from_view_ray(s.seen)) * (camera_from_world * s.geometric)));
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

std::vector<Candidate> scored(const std::vector<SurfaceNormal>& samples, Space space, const Camera& camera) {
  const std::vector<dvec3> wanted = in_space(samples, space, camera);
  std::vector<Candidate> candidates;
  for (const Axes& axes : all_axes()) {
    Candidate c{space, axes};
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double cosine = glm::dot(in_axes(axes, samples[i].stored), wanted[i]);
      c.score += std::abs(cosine) / double(samples.size());
      c.facing += cosine / double(samples.size());
    }
    candidates.push_back(c);
  }
  return candidates;
}

/// By how many standard errors one candidate beats another over the samples.
double advantage(const Candidate& a, const Candidate& b, const std::vector<SurfaceNormal>& samples, const Camera& camera) {
  const auto wanted_a = in_space(samples, a.space, camera), wanted_b = in_space(samples, b.space, camera);
  double sum = 0, squares = 0;
  const double n = double(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto cosine = [&](const Candidate& c, const std::vector<dvec3>& wanted) {
      return std::abs(glm::dot(in_axes(c.axes, samples[i].stored), wanted[i]));
    };
    const double gain = cosine(a, wanted_a) - cosine(b, wanted_b);
    sum += gain;
    squares += gain * gain;
  }
  const double mean = sum / n, variance = squares / n - mean * mean;
  return mean / std::sqrt(std::max(variance, 1e-12) / n);
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
  if (c.facing >= 0) return;
  c.axes = inverted(c.axes);
  c.facing = -c.facing;
}

const char* name_of(Space space) { return space == Space::world ? "world" : space == Space::camera ? "camera" : "view ray (V-Ray)"; }
std::string words(const Candidate& c) { return std::string(name_of(c.space)) + (c.axes == Axes{} ? "" : ", axes " + text_of(c.axes)); }

bool allowed(const Candidate& c, const ReadingOptions& options) {
  return (!options.normal_space || *options.normal_space == c.space) && (!options.normal_axes || *options.normal_axes == c.axes);
}

std::vector<Candidate> candidates_of(const std::vector<SurfaceNormal>& samples, const Asked& asked, const Reading& reading) {
  std::vector<Space> spaces{reading.normal_space};
  for (const Space space : {Space::world, Space::camera})
    if (space != reading.normal_space) spaces.push_back(space);
  std::vector<Candidate> candidates;
  for (const Space space : spaces)
    for (const Candidate& c : scored(samples, space, *reading.camera))
      if (allowed(c, asked.options)) candidates.push_back(c);
  if (reading.normal_space == Space::view_ray) return candidates;
  // V-Ray's frame also where another program has dropped its marks: as V-Ray stores it only, since flipped it differs from camera space by little.
  const Candidate view_ray = scored(samples, Space::view_ray, *reading.camera).front();
  if (allowed(view_ray, asked.options)) candidates.push_back(view_ray);
  return candidates;
}

/// The best that does not say the same as the chosen one, seen from the other side.
const Candidate* rival_of(const Candidate& chosen, const std::vector<Candidate>& all) {
  const Candidate* rival = nullptr;
  for (const Candidate& c : all) {
    if (c.space == chosen.space && (c.axes == chosen.axes || c.axes == inverted(chosen.axes))) continue;
    if (!rival || c.score > rival->score) rival = &c;
  }
  return rival;
}

}  // namespace

void ask_normal_space(const Asked& asked, Reading& reading) {
  if (!reading.roles.contains("normal") || !reading.camera || (asked.options.normal_space && asked.options.normal_axes)) return;
  const std::vector<SurfaceNormal> samples = surface_normals(asked, reading);
  constexpr std::size_t few = 64;
  if (samples.size() < few) return;
  const std::vector<Candidate> all = candidates_of(samples, asked, reading);
  const auto same = [&](const Candidate& c) { return c.space == reading.normal_space && c.axes == reading.normal_axes; };
  const auto before = std::find_if(all.begin(), all.end(), same);
  const Candidate prior = before == all.end() ? all.front() : *before;
  const double top = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.score < b.score; })->score;
  constexpr double as_good = 0.003;  // mean cosine: what bumps and smooth shading move it by
  const auto best = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.score > top - as_good; });  // the plainest of the best
  // A reading is overturned only for one that explains nearly everything, and beyond chance.
  constexpr double explains = 0.85, gain = 0.01, beyond_chance = 8;
  const bool overturned =
      best->score > explains && best->score > prior.score + gain && advantage(*best, prior, samples, *reading.camera) > beyond_chance;
  Candidate chosen = overturned ? *best : prior;
  if (!asked.options.normal_axes) face_viewer(chosen, reading);
  const Candidate* const rival = rival_of(chosen, all);
  reading.normal_space = chosen.space;
  reading.normal_axes = chosen.axes;
  reading.verdicts.push_back({"normal space", words(chosen),
                              "mean cosine to the surfaces that the positions span: " + in_words(chosen.score) +
                                  (rival ? "; next: " + words(*rival) + " " + in_words(rival->score) : ""),
                              "--normal-space, --normal-axes", chosen.score > explains && (!rival || chosen.score > rival->score + gain)});
  if (chosen.score < explains)
    reading.notes.push_back("warning: normals agree with the positions to a mean cosine of " + in_words(chosen.score) +
                            " only, and with no other space or axes better: bump maps, or a frame of their own (--map normal=LAYER, --normal-space)");
}

}  // namespace relume
