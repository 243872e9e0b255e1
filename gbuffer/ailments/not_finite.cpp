// NaN and infinities, layer by layer, where a surface should be.
#include <cmath>

#include "gbuffer/ailments/ailment.h"

namespace relume {
namespace {

enum Kind { nan, positive, negative, kinds };

bool finite(const std::vector<const float*>& components, std::size_t i) {
  for (const float* const c : components)
    if (!std::isfinite(c[i])) return false;
  return true;
}

/// Background may hold anything: pixels that coverage, depth (beside a normal that is one) or a zero normal or position call empty do not count.
class Background {
 public:
  Background(const Row& row, const std::string& role)
      : coverage_(role == "coverage" ? nullptr : row.stored("coverage")),
        depth_(role == "depth" ? nullptr : row.stored("depth")),
        farthest_(float(row.reading.background_depth)),
        normal_(row.components("normal")),
        position_(row.components("position")) {}

  bool at(std::size_t i) const {
    if (coverage_ && coverage_[i] <= 0) return true;
    if (depth_ && std::abs(depth_[i]) >= farthest_ && (normal_.empty() || finite(normal_, i))) return true;
    return zero(normal_, i) || zero(position_, i);
  }

 private:
  static bool zero(const std::vector<const float*>& v, std::size_t i) { return v.size() == 3 && v[0][i] == 0 && v[1][i] == 0 && v[2][i] == 0; }

  const float *coverage_, *depth_;
  const float farthest_;
  const std::vector<const float*> normal_, position_;
};

/// A pixel counts once a layer: as NaN, else by the sign of its infinity.
void look(const Row& row, const std::string& role, std::span<Tally> tallies) {
  const auto components = row.components(role);
  const Background background(row, role);
  for (std::size_t i = 0; i < std::size_t(row.width); ++i) {
    if (finite(components, i) || background.at(i)) continue;
    Kind kind = kinds;
    for (const float* const c : components)
      if (!std::isfinite(c[i])) kind = std::min(kind, std::isnan(c[i]) ? nan : c[i] > 0 ? positive : negative);
    // A depth that is infinite means that nothing is there, unless the coverage says otherwise.
    if (role == "depth" && kind != nan && !row.stored("coverage") && finite(row.components("normal"), i)) continue;
    tallies[kind].add(row.min_x + int(i), row.y);
  }
}

std::string effect_of(const std::string& role) {
  if (role == "normal" || role == "position" || role == "depth" || role == "coverage") return "these pixels count as background and stay black";
  if (role.starts_with("layer ")) return "what is made from it is not finite there";
  return "these pixels are shaded with 0 in its place";
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  for (const auto& [role, layer] : patient.reading.roles) {
    if (layer.types.front() == SampleType::uint32) continue;
    Check check;
    check.roles = {role};
    check.tallies = kinds;
    check.look = [role = role](const Row& row, std::span<Tally> tallies) { look(row, role, tallies); };
    check.conclude = [role = role, name = layer.layer](std::span<const Tally> tallies, std::vector<Finding>& findings) {
      const char* const words[] = {"NaN", "infinite", "minus infinite"};
      for (int k = 0; k < kinds; ++k)
        if (tallies[k].pixels)
          findings.push_back({"", Severity::defect, name, tallies[k], std::to_string(tallies[k].pixels) + " pixels are " + words[k], effect_of(role),
                              "render the layer again; --map " + role + "=LAYER takes another"});
    };
    checks.push_back(std::move(check));
  }
}

}  // namespace

extern const Ailment ailment_not_finite;
const Ailment ailment_not_finite{"not_finite", "NaN or infinite values", examine};

}  // namespace relume
