// bound_clusters for any processor.
#define RELUME_BOUNDS_OF portable
#include "host/cluster_bounds_lanes.h"
