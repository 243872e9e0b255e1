// Are normals stored as -1..1, or as 0..1 for -1..1? Unit length tells, and so does any component below 0.
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/solver/question.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

struct Lengths {
  double all = 0, as_signed = 0, as_unsigned = 0,
         negative = 0;  ///< pixels: with a normal, of unit length in either reading, with a component below 0
};

Lengths lengths_in(const std::vector<SampledBand>& bands) {
  constexpr double unit = 0.02;         // 8 bits leave 0.007
  constexpr double below_zero = -0.01;  // an encoded 0 may be rounded a little below
  Lengths lengths;
  for (const SampledBand& band : bands) {
    for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
      const glm::dvec3 n = band.vector("normal", i);
      const double plain = glm::length(n);
      if (!(plain > 0) || !std::isfinite(plain)) continue;
      ++lengths.all;
      lengths.as_signed += std::abs(plain - 1) < unit;
      lengths.as_unsigned += std::abs(glm::length(2.0 * n - 1.0) - 1) < unit;
      lengths.negative += n.x < below_zero || n.y < below_zero || n.z < below_zero;
    }
  }
  return lengths;
}

}  // namespace

void ask_normal_encoding(const Asked& asked, Reading& reading) {
  if (!reading.roles.contains("normal") || asked.options.normal_encoding) return;
  const Lengths lengths = lengths_in(asked.bands);
  if (lengths.all == 0) return;
  const double as_signed = lengths.as_signed / lengths.all, as_unsigned = lengths.as_unsigned / lengths.all,
               negative = lengths.negative / lengths.all;
  constexpr double many = 0.5, rare = 0.01;  // filters with negative lobes push a few encoded values below 0
  const NormalEncoding before = reading.normal_encoding;
  if (negative > rare)
    reading.normal_encoding = NormalEncoding::as_signed;
  else if (as_unsigned > many && as_unsigned > 2 * as_signed)
    reading.normal_encoding = NormalEncoding::as_unsigned;
  else if (as_signed > many && as_signed > 2 * as_unsigned)
    reading.normal_encoding = NormalEncoding::as_signed;
  const bool is_signed = reading.normal_encoding == NormalEncoding::as_signed;
  const bool sure = is_signed ? negative > rare || as_signed > 2 * as_unsigned : as_unsigned > 2 * as_signed;
  reading.verdicts.push_back({"normal encoding", is_signed ? "signed (-1..1)" : "unsigned (0..1)",
                              "of unit length as -1..1: " + three_digits(100 * as_signed) + " % of the pixels, as 0..1: " +
                                  three_digits(100 * as_unsigned) + " %; below 0: " + three_digits(100 * negative) + " %",
                              "--normal-encoding", sure});
  if (before != reading.normal_encoding)
    reading.notes.push_back("normals are read as " + std::string(is_signed ? "-1..1" : "0..1 for -1..1") +
                            ", though the convention has it otherwise: their lengths tell (--normal-encoding overrules)");
}

}  // namespace relume
