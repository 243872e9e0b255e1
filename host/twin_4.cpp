// The twin with 4 lanes.
#define RELUME_LANES 4
#include "host/twin_lanes.h"
