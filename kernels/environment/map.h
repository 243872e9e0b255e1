// An environment's texels: where a direction meets the latitude-longitude image, the direction of a place on it, and what light comes from there.
#ifndef RELUME_ENVIRONMENT_MAP_H
#define RELUME_ENVIRONMENT_MAP_H

#include "kernels/frame.h"
#include "kernels/math.h"

/// In texels, 0 at the first one's centre; the sine is of the angle from the pole.
typedef struct {
  real x, y, sine;
} MapPlace;

/// `m`: EnvironmentRecord::world_from_map.
RELUME_FN real3 direction_at(RELUME_GLOBAL const EnvironmentImage* image, RELUME_GLOBAL const float* m, MapPlace place, real cosine) {
  const real turn = (place.x + image->column_shift) * (1.0f / (float)image->width);
  const real x = cosine_of_turn(turn) * place.sine, y = sine_of_turn(turn) * place.sine;
  return real3_of(m[0] * x + m[1] * y + m[2] * cosine, m[3] * x + m[4] * y + m[5] * cosine, m[6] * x + m[7] * y + m[8] * cosine);
}

RELUME_FN MapPlace place_of(RELUME_GLOBAL const EnvironmentImage* image, RELUME_GLOBAL const float* m, real3 l) {
  const real x = m[0] * l.x + m[3] * l.y + m[6] * l.z, y = m[1] * l.x + m[4] * l.y + m[7] * l.z, z = m[2] * l.x + m[5] * l.y + m[8] * l.z;
  MapPlace place;
  place.sine = square_root(x * x + y * y);
  place.x = angle_of(x, y) * ((float)image->width * (0.5f * RELUME_INVERSE_PI)) - image->column_shift;
  place.y = angle_of(z, place.sine) * (image->row_steps * RELUME_INVERSE_PI) - image->row_shift;
  return place;
}

/// The four texels around a place, and how far it is from the first towards the others.
typedef struct {
  integer left, right, top, bottom;
  real across, down;
} Corners;

/// Columns go round, the first and last rows go on to the poles. A place that is NaN must not lead out of the tables.
RELUME_FN Corners corners_of(RELUME_GLOBAL const EnvironmentImage* image, MapPlace place) {
  const real left = whole_below(place.x), top = whole_below(place.y), width = all_lanes((float)image->width);
  const float last_row = (float)(image->height - 1);
  const real turned = choose(left < 0.0f, left + width, choose(left >= width, left - width, left));
  const real wrapped = clamped(turned, 0.0f, (float)(image->width - 1));
  Corners corners;
  corners.left = to_integer(wrapped);
  corners.right = to_integer(choose(wrapped + 1.0f >= width, all_lanes(0.0f), wrapped + 1.0f));
  corners.top = to_integer(clamped(top, 0.0f, last_row));
  corners.bottom = to_integer(clamped(top + 1.0f, 0.0f, last_row));
  corners.across = place.x - left;
  corners.down = place.y - top;
  return corners;
}

/// W/(m^2 sr) r, g, b; `offset`: from the image's first texel.
RELUME_FN real3 texel_at(RELUME_GLOBAL const EnvironmentImage* image, RELUME_GLOBAL const float* tables, integer row, integer column,
                         integer offset) {
  const integer at = (row * image->width + column) * 3 + offset;
  RELUME_GLOBAL const float* texels = tables + image->texels;
  return real3_of(gather(texels, at), gather(texels, at + 1), gather(texels, at + 2));
}

/// Bilinear.
RELUME_FN real3 texels_at(RELUME_GLOBAL const EnvironmentImage* image, RELUME_GLOBAL const float* tables, Corners c, integer offset) {
  const real3 top = mix3(texel_at(image, tables, c.top, c.left, offset), texel_at(image, tables, c.top, c.right, offset), c.across);
  const real3 bottom = mix3(texel_at(image, tables, c.bottom, c.left, offset), texel_at(image, tables, c.bottom, c.right, offset), c.across);
  return mix3(top, bottom, c.down);
}

#endif
