// The sum over lights where a work-item has one pixel, as on GPUs: a group takes its lights into local memory, 16 of each list at a time.
#ifndef RELUME_STAGED_LIGHTS_H
#define RELUME_STAGED_LIGHTS_H

#include "kernels/one_light.h"

#ifdef RELUME_STAGED

/// One for each work-item of a group: the lights that the blocks of pixels in it meet next.
typedef struct {
  LightRecord light[RELUME_STAGED_ITEMS];
  int number[RELUME_STAGED_ITEMS];
} Stage;

/// How many lights are listed for the block that pixel i begins.
RELUME_FN int listed_for(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const int* lists, int i) {
  if (i >= frame->pixels) return 0;
  return lists[frame->lists + 2 * (i / RELUME_LISTED_PIXELS) + 1] - lists[frame->lists + 2 * (i / RELUME_LISTED_PIXELS)];
}

/// How many lights the group's longest list has: as often do all its work-items meet at the barriers.
RELUME_FN int longest_of_group(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const int* lists, int first) {
  if (frame->lists == 0) return frame->light_begin[LIGHT_COUNT] - frame->light_begin[0];
  int longest = 0;
  for (int i = first; i < first + RELUME_STAGED_ITEMS; i += RELUME_LISTED_PIXELS) longest = max(longest, listed_for(frame, lists, i));
  return longest;
}

/// `sum` with the lights of the pixel's list, or with all, where it is `mine`. Every work-item of the group calls this, whatever it shows.
RELUME_FN Radiance direct_light(Choice choice, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const LightRecord* lights,
                                RELUME_GLOBAL const int* lists, Surface s, Seen seen, Radiance sum, int i, mask mine, __local Stage* stage) {
  const int item = (int)get_local_id(0), slot = item % RELUME_LISTED_PIXELS, listed = frame->lists > 0;
  const int begin = !listed ? frame->light_begin[0] : i < frame->pixels ? lists[frame->lists + 2 * (i / RELUME_LISTED_PIXELS)] : 0;
  const int count = listed ? listed_for(frame, lists, i) : frame->light_begin[LIGHT_COUNT] - begin;
  const int longest = longest_of_group(frame, lists, i - item);
  for (int at = 0; at < longest; at += RELUME_LISTED_PIXELS) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (at + slot < count) {
      const int number = listed ? lists[begin + at + slot] : begin + at + slot;
      stage->light[item] = lights[number];
      stage->number[item] = number;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int here = mine ? min(RELUME_LISTED_PIXELS, count - at) : 0;
    for (int k = item - slot; k < item - slot + here; ++k) {
      const Incident in = incident_from(frame, &stage->light[k], stage->number[k], s.position);
      const Cosines c = cosines_of(s.n, in.l, s.v);
      const real share = facing_share(in, c, s, frame->bump_shadowing);
      if (share > 0.0f) sum = with_light(sum, choice, &stage->light[k], share, c, s, seen);
    }
  }
  return sum;
}

#endif
#endif
