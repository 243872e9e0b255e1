// What each lobe and light costs, counted: the table behind every flop/s.
#pragma once

#include <ostream>

namespace relume::bench {

/// For each lobe under a point light, and each light on Lambert: operations of a light, then flops and bytes of a pixel.
void print_costs(std::ostream& out);

}  // namespace relume::bench
