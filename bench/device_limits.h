// What the devices at hand can do at best, measured before anything else: the yardstick for every share of the peak.
#pragma once

#include "bench/bench.h"

namespace relume::bench {

/// Measures them, fills `bench.devices[...].limits`, `processor` and `one_thread`, and keeps the measurements.
void measure_limits(Bench& bench);

}  // namespace relume::bench
