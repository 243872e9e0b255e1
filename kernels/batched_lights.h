// The sum over lights where a work-item has several pixels: on CPUs, and in C++.
#ifndef RELUME_BATCHED_LIGHTS_H
#define RELUME_BATCHED_LIGHTS_H

#include "kernels/one_light.h"

#ifndef RELUME_STAGED

/// Lights that are met before any is reflected.
#define RELUME_BATCH 16

#define RELUME_DECLARE_BATCH(member) real batch_##member[RELUME_BATCH];
#define RELUME_PUT_INTO_BATCH(member) batch_##member[arrivals] = c.member;
#define RELUME_TAKE_FROM_BATCH(member) c.member = batch_##member[k];

/// `sum` with the lights of the pixels' list, or with all. They come in batches, through short loops one after the other: a processor has some 200
/// vector instructions under way at a time, which one loop over everything would fill with a light or two, whose operations wait for each other.
/// For the same reason a light's direction is worked out while the one before it is met. What reaches no lane is left out without a branch that could
/// be mispredicted. Each member of the cosines has its own array, so that one which no lobe reads is dropped.
RELUME_FN Radiance direct_light(Choice choice, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const LightRecord* lights,
                                RELUME_GLOBAL const int* lists, Surface s, Seen seen, Radiance sum, int i) {
  const int listed = frame->lists > 0;
  RELUME_GLOBAL const int* own = lists + (listed ? frame->lists + 2 * (i / RELUME_LISTED_PIXELS) : 0);
  const int end = listed ? own[1] : frame->light_begin[LIGHT_COUNT];
  int next = listed ? own[0] : frame->light_begin[0];
  if (next >= end) return sum;
  int from[RELUME_BATCH], light = listed ? lists[next] : next;
  real share[RELUME_BATCH];
  RELUME_COSINES(RELUME_DECLARE_BATCH)
  Incident coming = incident_from(frame, lights + light, light, s.position);
  while (next < end) {
    int arrivals = 0;
    for (; next < end && arrivals < RELUME_BATCH; ++next) {
      const Incident in = coming;
      from[arrivals] = light;
      if (next + 1 < end) light = listed ? lists[next + 1] : next + 1;
      coming = incident_from(frame, lights + light, light, s.position);  // the last one once more: a branch would cost more
      const Cosines c = cosines_of(s.n, in.l, s.v);
      RELUME_COSINES(RELUME_PUT_INTO_BATCH)
      share[arrivals] = facing_share(in, c, s, frame->bump_shadowing);
      arrivals += any_of(share[arrivals] > 0.0f);
    }
    for (int k = 0; k < arrivals; ++k) {
      Cosines c;
      c.n_v = s.n_v;
      RELUME_COSINES(RELUME_TAKE_FROM_BATCH)
      sum = with_light(sum, choice, lights + from[k], share[k], c, s, seen);
    }
  }
  return sum;
}

#endif
#endif
