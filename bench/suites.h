// What is measured, by suite, in the order of the run: a file <name>_suite.cpp with <name>_groups, and its line here.
#pragma once

#include <vector>

#include "bench/bench.h"

namespace relume::bench {

#define RELUME_SUITES(SUITE) \
  SUITE(yardstick)           \
  SUITE(scaling)             \
  SUITE(kernel)              \
  SUITE(many_lights)         \
  SUITE(growth)              \
  SUITE(live)                \
  SUITE(pipeline)

#define RELUME_DECLARE_SUITE(name) std::vector<Group> name##_groups(const Bench& bench);
RELUME_SUITES(RELUME_DECLARE_SUITE)
#undef RELUME_DECLARE_SUITE

}  // namespace relume::bench
