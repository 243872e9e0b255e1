// plane_samples: intervals are halved, all at once in each round, until a chord and the curve agree; then the highest sample is closed in on.
#include "lab/plane_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relume {
namespace {

constexpr double horizon = 89.99;  // degrees: a figure shows no difference to 90, where there is no f_r
constexpr double grazing = 80;     // degrees: to where what grows without end is shown
constexpr LobePart parts[] = {LobePart::total, LobePart::diffuse, LobePart::specular};

/// Every half degree, and ever closer to where a lobe's tip may stand: the mirror direction, the retro-reflected one, the horizon.
std::vector<double> first_angles(const Arrangement& arrangement) {
  std::vector<double> angles;
  for (double angle = -horizon + 0.49; angle < horizon; angle += 0.5) angles.push_back(angle);
  for (const double centre : {arrangement.angle, -arrangement.angle, horizon, -horizon}) {
    angles.push_back(centre);
    for (double offset = 8; offset > 1e-4; offset /= 2)
      for (const double angle : {centre - offset, centre + offset}) angles.push_back(angle);
  }
  std::erase_if(angles, [](double angle) { return std::abs(angle) > horizon; });
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

class Sampler {
 public:
  Sampler(const Brdf& brdf, const Arrangement& arrangement, const Measure& measure) : brdf_(brdf), arrangement_(arrangement), measure_(measure) {
    add(first_angles(arrangement));
  }

  void add(const std::vector<double>& angles) {
    std::vector<DirectionPair> pairs;
    for (const double angle : angles) pairs.push_back(arrangement_.with(in_plane(angle)));
    const std::vector<Reflectance> values = brdf_.reflectance(pairs);
    for (std::size_t i = 0; i < angles.size(); ++i) samples_.push_back({angles[i], pairs[i], values[i]});
    std::sort(samples_.begin(), samples_.end(), [](const PlaneSample& a, const PlaneSample& b) { return a.angle < b.angle; });
  }

  /// The middles of intervals beside samples that the chord over both neighbours misses.
  std::vector<double> bent() const {
    double peaks[3];
    for (const LobePart part : parts) peaks[int(part)] = tip_of(samples_, measure_, part).value;
    std::vector<char> halved(samples_.size(), 0);
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i)
      if (misses(i, peaks)) halved[i - 1] = halved[i] = 1;
    std::vector<double> middles;
    constexpr double finest = 1e-4;  // degrees
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
      if (halved[i] && samples_[i + 1].angle - samples_[i].angle > finest) middles.push_back((samples_[i].angle + samples_[i + 1].angle) / 2);
    return middles;
  }

  /// Angles between the neighbours of a part's highest sample.
  std::vector<double> around_tip(LobePart part) const {
    const double angle = tip_of(samples_, measure_, part).angle;
    const auto at = std::find_if(samples_.begin(), samples_.end(), [&](const PlaneSample& s) { return s.angle >= angle; });
    std::vector<double> angles;
    if (at == samples_.begin() || at == samples_.end() || at + 1 == samples_.end()) return angles;
    for (const auto side : {at - 1, at + 1})
      for (int k = 1; k < 8; ++k) angles.push_back(angle + (side->angle - angle) * k / 8);
    return angles;
  }

  const std::vector<PlaneSample>& samples() const { return samples_; }

 private:
  double shown(std::size_t i, LobePart part) const { return measure_(samples_[i].value, samples_[i].pair.l.z, part); }

  /// By more than a thousandth of the peak or, for logarithms, a hundredth of itself.
  bool misses(std::size_t i, const double* peaks) const {
    const double a = samples_[i - 1].angle, b = samples_[i].angle, c = samples_[i + 1].angle;
    for (const LobePart part : parts) {
      const double here = shown(i, part), peak = peaks[int(part)];
      const double chord = shown(i - 1, part) + (shown(i + 1, part) - shown(i - 1, part)) * (b - a) / (c - a);
      if (std::abs(here - chord) > std::max(std::min(1e-3 * peak, 1e-2 * here), 1e-6 * peak)) return true;
    }
    return false;
  }

  const Brdf& brdf_;
  const Arrangement& arrangement_;
  const Measure& measure_;
  std::vector<PlaneSample> samples_;
};

}  // namespace

std::vector<PlaneSample> plane_samples(const Brdf& brdf, const Arrangement& arrangement, const Measure& measure) {
  Sampler sampler(brdf, arrangement, measure);
  constexpr std::size_t most = 20000;  // a figure's width is some thousand
  for (std::vector<double> next = sampler.bent(); !next.empty() && sampler.samples().size() < most; next = sampler.bent()) sampler.add(next);
  for (int round = 0; round < 3; ++round)
    for (const LobePart part : parts) sampler.add(sampler.around_tip(part));
  return sampler.samples();
}

Tip tip_of(const std::vector<PlaneSample>& samples, const Measure& measure, LobePart part) {
  const auto shown = [&](const PlaneSample& s) { return measure(s.value, s.pair.l.z, part); };
  const auto highest = [&](double limit) {
    auto at = samples.end();
    for (auto s = samples.begin(); s != samples.end(); ++s)
      if (std::abs(s->angle) <= limit && (at == samples.end() || shown(*s) > shown(*at))) at = s;
    // Single precision makes a plateau of a tip: its middle.
    const double level = shown(*at) * (1 - 1e-6);
    auto first = at, last = at;
    while (first != samples.begin() && shown(*(first - 1)) >= level) --first;
    while (last + 1 != samples.end() && shown(*(last + 1)) >= level) ++last;
    return Tip{(first->angle + last->angle) / 2, shown(*at), true};
  };
  Tip tip = highest(horizon);
  // Like 1/n.l: at a tenth of the elevation ten times as much.
  const auto tenth = [&](const PlaneSample& s) { return std::abs(std::abs(s.angle) - 89.9) < 0.05 && s.angle * tip.angle > 0; };
  const auto there = std::find_if(samples.begin(), samples.end(), tenth);
  if (std::abs(tip.angle) < 89.98 || there == samples.end() || tip.value < 2 * shown(*there)) return tip;
  tip = highest(grazing);
  tip.bounded = false;
  return tip;
}

}  // namespace relume
