// bound_clusters for avx2 processors.
#define RELUME_BOUNDS_OF avx2
#include "host/cluster_bounds_lanes.h"
