// LightCuts: from a coarse cut down, those clusters opened first whose errors are the largest shares of what is allowed.
#include "host/light_cuts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "host/cluster_bounds.h"

namespace relume {
namespace {

/// Of the error that is allowed: the rest covers what rounding makes of bounds, radiances and moments (some 1e-4 of them).
constexpr float used_share = 0.99f;
/// Clusters at a time that cuts start from: two rounds of bounds.
constexpr std::size_t top_clusters = 2 * bounded_at_once;
/// Four stand-ins are worth it where they cut the error of one by this.
constexpr float gain_of_four = 3, gain_of_four_over_three = 1.1f;

/// Normals' spread: without highlights, where it leaves a lower bound of the radiance; with them, below the width of most.
constexpr float turn_without_highlights = 0.5f, turn_with_highlights = 0.08f;

/// A sum of shares at which little is known yet of what arrives, and so of what is allowed.
constexpr float far_from_done = 8;

/// What a channel of a patch's pixels must keep to, for extreme values of what the halves of its BRDF are proportional to: in between it holds too,
/// as errors and radiances are both linear in them.
struct Condition {
  int patch, channel;
  float factor[halves];
};

std::vector<float> extremes(const PixelPatch& patch, const LobeFactor& factor, int channel) {
  if (factor.field < 0) return {1};
  const float low = patch.low[factor.field][channel] * factor.scale, high = patch.high[factor.field][channel] * factor.scale;
  return low < high ? std::vector<float>{low, high} : std::vector<float>{low};
}

/// A cut in the making.
class Cut {
 public:
  Cut(const LightTree& tree, std::span<const Choice> programs, std::span<const float> tables, float error, std::span<const PixelPatch> patches)
      : tree_(tree), programs_(programs), tables_(tables), error_(error), patches_(patches) {
    for (int p = 0; p < int(patches.size()); ++p) add_conditions(p);
    settled_.assign(conditions_.size(), 0);
  }

  void refine(std::span<const int> top, std::vector<int>& numbers) {
    bound(top, numbers);
    std::vector<int> opened;
    while (open_worst(opened, numbers)) bound(opened, numbers);
    for (const Member& member : members_)
      for (int k = 0; k < member.count; ++k) numbers.push_back(member.first + k);
  }

 private:
  struct Member {
    int cluster, first, count;  ///< what stands in for it
  };

  void add_conditions(int p) {
    const PixelPatch& patch = patches_[std::size_t(p)];
    const Choice& choice = programs_[std::size_t(patch.program)];
    for (int c = 0; c < 3; ++c)
      for (const float diffuse : extremes(patch, diffuse_factor(choice), c))
        for (const float specular : extremes(patch, specular_factor(choice), c)) conditions_.push_back({p, c, {diffuse, specular}});
  }

  float weighed(const Condition& condition, const float (&bounds)[halves][3][bounded_at_once], std::size_t lane) const {
    return condition.factor[half_diffuse] * bounds[half_diffuse][condition.channel][lane] +
           condition.factor[half_specular] * bounds[half_specular][condition.channel][lane];
  }

  /// Makes members of clusters; those that are dark are left out, and those that nothing stands in for are met themselves.
  void bound(std::span<const int> clusters, std::vector<int>& numbers) {
    thread_local std::vector<ClusterBounds> bounds;
    bounds.resize(patches_.size());
    for (std::size_t first = 0; first < clusters.size(); first += bounded_at_once) {
      const std::span<const int> which = clusters.subspan(first, std::min<std::size_t>(bounded_at_once, clusters.size() - first));
      for (std::size_t p = 0; p < patches_.size(); ++p)
        bound_clusters(programs_[std::size_t(patches_[p].program)], patches_[p], tables_.data(), tree_.clusters(), which, bounds[p]);
      for (std::size_t lane = 0; lane < which.size(); ++lane)
        if (std::any_of(bounds.begin(), bounds.end(), [&](const ClusterBounds& b) { return b.high[lane] > 0; }))
          add(which[lane], bounds, lane, numbers);
    }
  }

  void add(int number, const std::vector<ClusterBounds>& bounds, std::size_t lane, std::vector<int>& numbers) {
    const LightCluster& cluster = tree_.clusters()[std::size_t(number)];
    if (cluster.one.count == 0) {
      for (std::size_t k = 0; k < conditions_.size(); ++k)
        settled_[k] += weighed(conditions_[k], bounds[std::size_t(conditions_[k].patch)].low, lane);
      return meet_lights(cluster, numbers);
    }
    float one = 0, four = 0;
    const std::size_t row = errors_.size();
    for (const Condition& condition : conditions_) {
      const ClusterBounds& b = bounds[std::size_t(condition.patch)];
      lows_.push_back(weighed(condition, b.low, lane));
      errors_.push_back(weighed(condition, b.one, lane));
      one += errors_.back(), four += weighed(condition, b.four, lane);
    }
    const float gain = cluster.one.count == 1 ? gain_of_four : gain_of_four_over_three;
    const bool use_four = cluster.four.count > 0 && four * gain < one;
    if (use_four)
      for (std::size_t k = 0; k < conditions_.size(); ++k)
        errors_[row + k] = weighed(conditions_[k], bounds[std::size_t(conditions_[k].patch)].four, lane);
    const StandIns& chosen = use_four ? cluster.four : cluster.one;
    members_.push_back({number, chosen.first, chosen.count});
  }

  void meet_lights(const LightCluster& cluster, std::vector<int>& numbers) const {
    numbers.insert(numbers.end(), tree_.order().begin() + cluster.begin, tree_.order().begin() + cluster.end);
  }

  /// Each member's error as a share of what is allowed, where it is largest. A sum of at most 1 keeps every condition.
  float find_shares() {
    std::vector<float> allowed = settled_;
    for (std::size_t i = 0; i < lows_.size(); ++i) allowed[i % conditions_.size()] += lows_[i];
    // Where nothing is certain to arrive, nothing is allowed; 1e-30 keeps the quotient finite.
    for (float& a : allowed) a = 1 / (a > 0 ? std::max(used_share * error_ * a, 1e-30f) : 1e-30f);
    shares_.assign(members_.size(), 0);
    float sum = 0;
    for (std::size_t j = 0; j < members_.size(); ++j) {
      for (std::size_t k = 0; k < conditions_.size(); ++k) {
        const float share = errors_[j * conditions_.size() + k] * allowed[k];
        if (!(share <= shares_[j])) shares_[j] = share < 1e30f ? share : 1e30f;  // NaN is no bound either
      }
      sum += shares_[j];
    }
    return sum;
  }

  /// Takes the worst members out and lists their children. False where all is well.
  bool open_worst(std::vector<int>& opened, std::vector<int>& numbers) {
    const float sum = find_shares();
    if (sum <= 1) return false;
    const float least = least_opened(sum);
    opened.clear();
    std::size_t kept = 0;
    const std::size_t width = conditions_.size();
    for (std::size_t j = 0; j < members_.size(); ++j) {
      if (shares_[j] < least) {
        std::copy_n(errors_.begin() + std::ptrdiff_t(j * width), width, errors_.begin() + std::ptrdiff_t(kept * width));
        std::copy_n(lows_.begin() + std::ptrdiff_t(j * width), width, lows_.begin() + std::ptrdiff_t(kept * width));
        members_[kept++] = members_[j];
        continue;
      }
      const LightCluster& cluster = tree_.clusters()[std::size_t(members_[j].cluster)];
      if (cluster.first_child >= 0) {
        opened.push_back(cluster.first_child);
        opened.push_back(cluster.first_child + 1);
        continue;
      }
      for (std::size_t k = 0; k < width; ++k) settled_[k] += lows_[j * width + k];
      meet_lights(cluster, numbers);
    }
    members_.resize(kept), errors_.resize(kept * width), lows_.resize(kept * width);
    return true;
  }

  /// The share from which on members are opened: such that what remains, and what is expected of their children, is allowed; but far
  /// from there none that is four times less than the worst, as what is allowed grows with what is known.
  float least_opened(float sum) const {
    std::array<float, 256> sums{};  // by the exponent's bits
    for (const float share : shares_) sums[std::bit_cast<std::uint32_t>(share) >> 23] += share;
    int exponent = 255;
    while (exponent > 0 && sums[std::size_t(exponent)] == 0) --exponent;
    constexpr float left_by_children = 0.4f;
    float opened = 0;
    const int last = std::max(exponent - (sum > far_from_done ? 2 : 8), 1);
    for (; exponent >= last; --exponent) {
      opened += sums[std::size_t(exponent)];
      if (sum - opened + left_by_children * opened <= 1) break;
    }
    return std::bit_cast<float>(std::uint32_t(std::max(exponent, last)) << 23);
  }

  const LightTree& tree_;
  std::span<const Choice> programs_;
  std::span<const float> tables_;
  float error_;
  std::span<const PixelPatch> patches_;
  std::vector<Condition> conditions_;
  std::vector<Member> members_;
  std::vector<float> errors_, lows_;  ///< of each member, for each condition
  std::vector<float> settled_;        ///< for each condition, the least radiance by lights that are met themselves
  std::vector<float> shares_;
};

}  // namespace

LightCuts::LightCuts(const LightTree& tree, std::span<const Choice> programs, std::span<const float> tables, double error)
    : tree_(tree), programs_(programs), tables_(tables), error_(float(error)), most_turn_(turn_without_highlights), top_{0} {
  if (std::any_of(programs.begin(), programs.end(), [](const Choice& c) { return c.specular != SPECULAR_none; })) most_turn_ = turn_with_highlights;
  for (std::size_t next = 0; next < top_.size() && top_.size() < top_clusters;) {
    const LightCluster& cluster = tree.clusters()[std::size_t(top_[next])];
    if (cluster.first_child < 0) {
      ++next;
      continue;
    }
    top_.erase(top_.begin() + std::ptrdiff_t(next));
    top_.insert(top_.end(), {cluster.first_child, cluster.first_child + 1});
  }
}

void LightCuts::add_cut(std::span<const PixelPatch> patches, std::vector<int>& numbers) const {
  if (!patches.empty()) Cut(tree_, programs_, tables_, error_, patches).refine(top_, numbers);
}

}  // namespace relume
