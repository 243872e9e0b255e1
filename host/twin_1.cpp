// The twin with 1 lane.
#define RELUME_LANES 1
#include "host/twin_lanes.h"
