// Places on an environment's image drawn in proportion to its light: a row by the cumulative shares of rows, a texel by those within the row
// (pbrt-v4, PiecewiseConstant2D), and a place around it by its weight in the bilinear interpolation, so that the density is the interpolated one.
#ifndef RELUME_ENVIRONMENT_DRAW_H
#define RELUME_ENVIRONMENT_DRAW_H

#include "kernels/environment/map.h"

typedef struct {
  real3 radiance;
  real density;  // of samples drawn as below, 1/sr
} Incoming;

RELUME_FN real luminance_of(real3 c) { return 0.2125f * c.x + 0.7154f * c.y + 0.0721f * c.z; }

/// Bilinear, the density like the radiance.
RELUME_FN Incoming incoming_at(RELUME_GLOBAL const EnvironmentRecord* map, RELUME_GLOBAL const float* tables, MapPlace place) {
  const Corners c = corners_of(&map->image, place);
  const integer first = to_integer(all_lanes(0.0f));
  const real3 a = texel_at(&map->image, tables, c.top, c.left, first), b = texel_at(&map->image, tables, c.top, c.right, first);
  const real3 d = texel_at(&map->image, tables, c.bottom, c.left, first), e = texel_at(&map->image, tables, c.bottom, c.right, first);
  const real3 top = mix3(a, b, c.across), bottom = mix3(d, e, c.across);
  const real above = luminance_of(top) * gather(tables + map->row_density, c.top) * (1.0f - c.down);
  const real below = luminance_of(bottom) * gather(tables + map->row_density, c.bottom) * c.down;
  Incoming in;
  in.radiance = mix3(top, bottom, c.down);
  in.density = (above + below) / larger(place.sine, all_lanes(1e-6f));  // a texel's cell narrows towards the pole, but not to nothing
  return in;
}

/// Which of the shares u falls into, and how far into it, 0..1.
typedef struct {
  integer index;
  real within;
} Drawn;

/// `count` cumulative shares from each lane's own `first`.
RELUME_FN Drawn draw_share(RELUME_GLOBAL const float* shares, integer first, int count, real u) {
  const integer none = to_integer(all_lanes(0.0f)), one = to_integer(all_lanes(1.0f));
  integer low = first;
  for (int left = count; left > 1;) {
    const int part = left / 2;
    low = low + choose_integer(gather(shares, low + (part - 1)) <= u, one * part, none);
    left -= part;
  }
  Drawn drawn;
  drawn.index = low - first;
  const mask is_first = to_real(drawn.index) < 0.5f;
  const real begin = choose(is_first, all_lanes(0.0f), gather(shares, low - choose_integer(is_first, none, one)));
  drawn.within = clamped((u - begin) / (gather(shares, low) - begin), 0.0f, 1.0f);
  return drawn;
}

/// From 0..1 to -1..1, denser in the middle as a tent's height is.
RELUME_FN real tent(real t) { return choose(t < 0.5f, square_root(2.0f * t) - 1.0f, 1.0f - square_root(larger(2.0f - 2.0f * t, all_lanes(0.0f)))); }

/// The place and the cosine of its angle from the pole.
RELUME_FN MapPlace draw_place(RELUME_GLOBAL const EnvironmentRecord* map, RELUME_GLOBAL const float* tables, real u, real v, real* cosine) {
  const Drawn row = draw_share(tables + map->row_shares, to_integer(all_lanes(0.0f)), map->image.height, u);
  const Drawn column = draw_share(tables + map->column_shares, row.index * map->image.width, map->image.width, v);
  MapPlace place;
  place.x = to_real(column.index) + tent(column.within);
  // Beyond a pole the image goes on mirrored: that fills the half row, or halves the tent, that ends there.
  const float north = -map->image.row_shift, south = map->image.row_steps - map->image.row_shift;
  const real y = to_real(row.index) + tent(row.within), turned = choose(y < north, 2.0f * north - y, y);
  place.y = choose(turned > south, 2.0f * south - turned, turned);
  const real turn = (place.y + map->image.row_shift) * (0.5f / map->image.row_steps);
  place.sine = absolute(sine_of_turn(turn));
  *cosine = cosine_of_turn(turn);
  return place;
}

#endif
