// Object ids that lost their meaning: bits of whole numbers read as floats, more of them than a float tells apart, fractions.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

enum Kind { bits, too_large, fraction, kinds };

/// Above it neighbouring whole numbers are one float (half).
double largest_exact(SampleType type) { return type == SampleType::half_float ? 2048 : 16777216; }

std::uint32_t bits_of(float value) {
  std::uint32_t whole = 0;
  std::memcpy(&whole, &value, sizeof whole);
  return whole;
}

void look(const Row& row, SampleType type, std::span<Tally> tallies) {
  const float* const ids = row.stored("ids");
  for (std::size_t i = 0; ids && i < std::size_t(row.width); ++i) {
    for (Tally& tally : tallies) ++tally.judged;
    const int x = row.min_x + int(i);
    const double id = type == SampleType::uint32 ? double(bits_of(ids[i])) : double(ids[i]);
    if (!std::isfinite(id) || id == 0) continue;
    if (std::abs(id) > largest_exact(type))
      tallies[too_large].add(x, row.y, std::abs(id));
    else if (std::fpclassify(ids[i]) == FP_SUBNORMAL && type == SampleType::float32)
      tallies[bits].add(x, row.y, bits_of(ids[i]));  // 1 as a whole number is 1e-45 as a float
    else if (id < 0 || std::abs(id - std::round(id)) > 1e-3 * std::max(1.0, std::abs(id)))
      tallies[fraction].add(x, row.y);
  }
}

void conclude(std::span<const Tally> t, SampleType type, const std::string& layer, std::vector<Finding>& findings) {
  if (t[bits].pixels)
    findings.push_back(
        {"", Severity::defect, layer, t[bits],
         "ids are whole numbers whose bits were stored as floats, at " + share_in_words(t[bits]) + " (up to " + three_digits(t[bits].worst) + ")",
         "all objects become object 0 and share one material", "write ids as UINT channels, or as floats by value"});
  if (t[too_large].pixels && type == SampleType::uint32)
    findings.push_back({"", Severity::hint, layer, t[too_large],
                        "ids reach " + std::to_string(std::int64_t(t[too_large].worst)) + ", above 2^24, at " + share_in_words(t[too_large]),
                        "none here, whole-number channels are read as such; tools that read them as floats merge objects", ""});
  else if (t[too_large].pixels)
    findings.push_back({"", Severity::defect, layer, t[too_large],
                        "ids reach " + three_digits(t[too_large].worst) + ", and " +
                            (type == SampleType::half_float ? "half floats above 2048" : "floats above 2^24") + " do not tell neighbours apart, at " +
                            share_in_words(t[too_large]),
                        "objects may share an id, and so a material", "write ids as UINT channels, or --map ids=LAYER takes another"});
  if (t[fraction].pixels)
    findings.push_back(
        {"", Severity::hint, layer, t[fraction], "ids are no whole numbers at " + share_in_words(t[fraction]) + ": means over several objects",
         "each of these pixels takes the material of the neighbour that it is most like", "store ids with a closest filter, or Cryptomatte"});
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("ids")) return;
  const RoleLayer& layer = patient.layer("ids");
  const SampleType type = layer.types.front();
  checks.push_back({{"ids"},
                    kinds,
                    [type](const Row& row, std::span<Tally> tallies) { look(row, type, tallies); },
                    [type, name = layer.layer](std::span<const Tally> t, std::vector<Finding>& f) { conclude(t, type, name, f); }});
}

}  // namespace

extern const Ailment ailment_ids;
const Ailment ailment_ids{"ids", "object ids that cannot be told apart", examine};

}  // namespace relume
