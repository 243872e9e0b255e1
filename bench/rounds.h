// Measures subjects side by side with Google Benchmark: in each round every subject once, so that what disturbs the machine disturbs all of them.
#pragma once

#include <vector>

#include "bench/subject.h"

namespace relume::bench {

struct RoundOptions {
  int rounds = 11;
  bool rounds_are_asked_for = false;  ///< else slow subjects have fewer rounds, 3 at least
  double least_seconds = 0.02;        ///< of a round: quick subjects go several times
};

std::vector<Measurement> measure(const std::vector<Subject>& subjects, const RoundOptions& options);

}  // namespace relume::bench
