// The twin with 8 lanes.
#define RELUME_LANES 8
#include "host/twin_lanes.h"
