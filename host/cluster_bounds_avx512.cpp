// bound_clusters for avx512 processors.
#define RELUME_BOUNDS_OF avx512
#include "host/cluster_bounds_lanes.h"
