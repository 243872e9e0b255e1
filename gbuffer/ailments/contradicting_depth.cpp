// Depth that disagrees with positions and camera, be it along the axis or along the ray.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/median.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

using glm::dvec3;

struct Distance {
  double z, along_ray;
};

Distance distance_of(const Camera& camera, const dvec3& place) {
  const double z = -glm::dot(camera.backward(), place - camera.eye());
  return {z, camera.projection == Camera::Projection::orthographic ? z : glm::distance(place, camera.eye())};
}

/// What depth means, as most of the pixels have it: near is where it counts from, which some renderers place at the clipping plane (Mitsuba).
struct Meaning {
  bool along_ray = false;
  double near = 0;

  double expected_z(double depth, const Distance& d) const { return near + std::abs(depth) * (along_ray && d.along_ray > 0 ? d.z / d.along_ray : 1); }
};

constexpr double tolerance = 0.01;  // of z: half floats round by 0.0005, and within a pixel a slope passes through more

bool agrees(const Meaning& meaning, double depth, const Distance& d) {
  return std::abs(meaning.expected_z(depth, d) - d.z) <= tolerance * std::abs(d.z);
}

struct Sample {
  double depth;
  Distance distance;
};

/// Of a few rows: each costs the decoding of a block, and the meaning shows in any of them that crosses the scene.
std::vector<Sample> samples_of(const Patient& patient) {
  const Window& data = patient.reading.data_window;
  const LayerFrame frame(patient.reading);
  std::vector<Sample> samples;
  for (const int eighth : {4, 6, 2, 7, 1, 5, 3}) {
    constexpr std::size_t enough = 500;
    if (samples.size() >= enough && eighth < 6) break;
    const int y = data.min_y + int(std::int64_t(data.height()) * eighth / 8);
    const Window window{data.min_x, y, data.max_x, y + 1};
    const DecodedRows band(patient.file, patient.reading, {"position", "normal", "depth", "coverage"}, window);
    const Row row(band, patient.reading, frame, y);
    const float* const depth = row.stored("depth");
    for (std::size_t i = 0; i < row.place.size(); ++i)
      if (row.shown[i] == Shown::surface) samples.push_back({depth[i], distance_of(*patient.reading.camera, row.place[i])});
  }
  return samples;
}

double share_of(const Meaning& meaning, const std::vector<Sample>& samples) {
  const auto count = std::count_if(samples.begin(), samples.end(), [&](const Sample& s) { return agrees(meaning, s.depth, s.distance); });
  return double(count) / double(samples.size());
}

/// The median of what is missing to z.
double near_of(const Meaning& meaning, const std::vector<Sample>& samples) {
  std::vector<double> missing;
  for (const Sample& s : samples) missing.push_back(s.distance.z - meaning.expected_z(s.depth, s.distance));
  return median(std::move(missing));
}

struct Fit {
  Meaning meaning;
  double share = 0;
};

Fit best_fit(const std::vector<Sample>& samples) {
  Fit best;
  for (const bool along_ray : {false, true}) {
    const Meaning plain{along_ray, 0}, clipped{along_ray, near_of(plain, samples)};
    for (const Meaning& meaning : {plain, clipped})
      if (const double share = share_of(meaning, samples); share > best.share + 0.02) best = {meaning, share};  // the plainer, where equally good
  }
  return best;
}

void look(const Row& row, const Meaning& meaning, std::span<Tally> tallies) {
  const float* const depth = row.stored("depth");
  if (!depth || row.place.empty()) return;
  for (std::size_t i = 0; i < row.place.size(); ++i) {
    if (row.shown[i] != Shown::surface) continue;
    const Distance distance = distance_of(*row.reading.camera, row.place[i]);
    ++tallies[0].judged;
    if (!agrees(meaning, depth[i], distance))
      tallies[0].add(row.min_x + int(i), row.y, std::abs(meaning.expected_z(depth[i], distance) - distance.z) / std::abs(distance.z));
  }
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>& findings) {
  const Reading& reading = patient.reading;
  if (!patient.understood || !patient.has("depth") || !patient.has("position") || !patient.has("normal") || !reading.camera) return;
  const std::string layer = patient.layer("depth").layer;
  const std::vector<Sample> samples = samples_of(patient);
  if (samples.empty()) return;
  const Fit fit = best_fit(samples);
  if (fit.share < 0.5) {
    findings.push_back(
        {"",
         Severity::hint,
         layer,
         {},
         "depth is neither z nor distance in the positions' units: it agrees with them at " + three_digits(100 * fit.share) + " % of the pixels",
         "none: depth only tells background where there are positions",
         "--map depth=LAYER takes another layer"});
    return;
  }
  const auto conclude = [layer, fit](std::span<const Tally> tallies, std::vector<Finding>& found) {
    constexpr double edges = 0.02;  // of the pixels: silhouettes where one layer is filtered and the other is not
    if (tallies[0].share() > (fit.share > 0.98 ? 0 : edges) && tallies[0].pixels > 0)
      found.push_back({"", Severity::defect, layer, tallies[0],
                       std::string("depth (") + (fit.meaning.along_ray ? "distance" : "z") + ") and positions disagree by over 1 % at " +
                           share_in_words(tallies[0]) + ", by up to " + three_digits(100 * tallies[0].worst) + " %",
                       "positions are used; if they are what is wrong, light falls off wrongly there", "--map position=LAYER, --map depth=LAYER"});
  };
  checks.push_back({{}, 1, [meaning = fit.meaning](const Row& row, std::span<Tally> tallies) { look(row, meaning, tallies); }, conclude});
}

}  // namespace

extern const Ailment ailment_contradicting_depth;
const Ailment ailment_contradicting_depth{"contradicting_depth", "depth that disagrees with the positions", examine};

}  // namespace relume
