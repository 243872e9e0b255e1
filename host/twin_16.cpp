// The twin with 16 lanes.
#define RELUME_LANES 16
#include "host/twin_lanes.h"
