// weigh: each round's value, then their median and quartiles.
#include "bench/claim.h"

#include <algorithm>
#include <cmath>

namespace relume::bench {
namespace {

const Measurement* find(const std::vector<Measurement>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) { return m.subject.name == name; });
  return found == all.end() ? nullptr : &*found;
}

double value(Measure measure, const Subject& subject, double seconds, const Subject& other, double other_seconds) {
  const double pairs = subject.work.pairs(), other_pairs = other.work.pairs();
  switch (measure) {
    case Measure::rate_over:
      return (pairs > 0 && other_pairs > 0 ? pairs / other_pairs : 1) * other_seconds / seconds;
    case Measure::time_over:
      return seconds / other_seconds;
    case Measure::milliseconds:
      return seconds * 1e3;
    case Measure::peak_share:
      return subject.roof.flops > 0 ? subject.work.flops / seconds / subject.roof.flops : 0;
  }
  return 0;
}

/// As if each of its threads had had a processor to itself.
std::vector<double> undisturbed(const Measurement& m) {
  std::vector<double> seconds = m.cpu_seconds;
  for (double& s : seconds) s /= m.subject.roof.threads;
  return seconds;
}

}  // namespace

bool Weighed::met() const {
  const bool more_is_better = claim.measure == Measure::rate_over || claim.measure == Measure::peak_share;
  return claim.goal == 0 || (more_is_better ? median >= claim.goal : median <= claim.goal);
}

std::optional<Weighed> weigh(const Claim& claim, const std::vector<Measurement>& measured) {
  const Measurement *subject = find(measured, claim.subject), *other = claim.other.empty() ? subject : find(measured, claim.other);
  if (!subject || !other) return {};
  const auto each = [&](const std::vector<double>& seconds, const std::vector<double>& other_seconds) {
    std::vector<double> values;
    for (std::size_t round = 0; round < std::min(seconds.size(), other_seconds.size()); ++round)
      values.push_back(value(claim.measure, subject->subject, seconds[round], other->subject, other_seconds[round]));
    return values;
  };
  const std::vector<double> values = each(subject->seconds, other->seconds), processor = each(undisturbed(*subject), undisturbed(*other));
  return Weighed{claim, quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75), quantile(processor, 0.5)};
}

}  // namespace relume::bench
