// Lights against bounds of pixels, RELUME_LANES of them at a time: spheres, cones and half-spaces against boxes, with margins that rounding cannot
// cross, so that no light is left out that reaches. Included by twin_lanes.h, in its namespace.
#include "kernels/frame.h"
#include "kernels/vector.h"

struct Sphere {
  float centre[3], radius;
};

RELUME_FN Sphere around(const PixelBounds& b) {
  Sphere s{};
  for (int c = 0; c < 3; ++c) {
    const float side = b.high[c] - b.low[c];
    s.centre[c] = 0.5f * (b.low[c] + b.high[c]);
    s.radius += side * side;
  }
  s.radius = 0.5f * __builtin_sqrtf(s.radius);
  return s;
}

// Sums of products are not spelt as dot3: what is rounded once in C++ is a call for each lane, where vectors do not have it.
RELUME_FN real squared_length(real x, real y, real z) { return x * x + y * y + z * z; }

RELUME_FN real beyond(real low, real high) { return larger(larger(low, high), all_lanes(0.0f)); }

RELUME_FN mask is_near(const LightColumns& l, int i, const PixelBounds& b) {
  const real x = load(l.x + i), y = load(l.y + i), z = load(l.z + i);
  const real apart2 = squared_length(beyond(b.low[0] - x, x - b.high[0]), beyond(b.low[1] - y, y - b.high[1]), beyond(b.low[2] - z, z - b.high[2]));
  return !(apart2 > load(l.range2 + i));
}

/// Whether a cone meets the sphere: the distance from a cone's side is cos(outer) across - sin(outer) along.
RELUME_FN mask cone_meets(const LightColumns& l, int i, const Sphere& s) {
  const real x = s.centre[0] - load(l.x + i), y = s.centre[1] - load(l.y + i), z = s.centre[2] - load(l.z + i);
  const real along = x * load(l.axis_x + i) + y * load(l.axis_y + i) + z * load(l.axis_z + i);
  const real across = square_root(larger(squared_length(x, y, z) - along * along, all_lanes(0.0f)));
  const real slack = s.radius + reach_margin * (s.radius + absolute(x) + absolute(y) + absolute(z));
  return !(load(l.cosine + i) * across - load(l.sine + i) * along > slack);
}

RELUME_FN mask some_cone_meets(const LightColumns& l, int i, const PixelBounds* boxes, int box_count) {
  mask some = cone_meets(l, i, around(boxes[0]));
  for (int b = 1; b < box_count; ++b) some = some | cone_meets(l, i, around(boxes[b]));
  return some;
}

/// Whether a light is in front of some pixel: n.(light - p) = n.(light - q) - n.(p - q) is at most the sum over axes of the larger product, less the
/// deepest pixel.
RELUME_FN mask is_in_front(const LightColumns& l, int i, const PixelBounds& b) {
  const real w = load(l.w + i);
  const real dx = load(l.x + i) - w * b.reference[0], dy = load(l.y + i) - w * b.reference[1], dz = load(l.z + i) - w * b.reference[2];
  const real most = larger(b.normal_low[0] * dx, b.normal_high[0] * dx) + larger(b.normal_low[1] * dy, b.normal_high[1] * dy) +
                    larger(b.normal_low[2] * dz, b.normal_high[2] * dz);
  const float extent = (b.high[0] - b.low[0]) + (b.high[1] - b.low[1]) + (b.high[2] - b.low[2]);
  return !(most - w * b.deepest < -reach_margin * (absolute(dx) + absolute(dy) + absolute(dz) + extent));
}

/// A bit for each lane of the mask, the first lowest.
RELUME_FN unsigned bits_of(mask m) {
  integer bits = m;
#if RELUME_LANES > 1
  for (int lane = 0; lane < RELUME_LANES; ++lane) bits[lane] = 1 << lane;
#endif
  return static_cast<unsigned>(joined(m & bits));
}

static int places_near(const LightColumns& l, int first, int last, const PixelBounds* boxes, int box_count, int* places) {
  if (box_count == 0) return 0;
  int kept = 0;
  for (int i = first; i < last; i += RELUME_LANES) {
    mask near = is_near(l, i, boxes[0]);
    for (int b = 1; b < box_count; ++b) near = near | is_near(l, i, boxes[b]);
    if (l.any_cone) near = near & some_cone_meets(l, i, boxes, box_count);
    for (unsigned bits = bits_of(near); bits != 0; bits &= bits - 1) places[kept++] = i + __builtin_ctz(bits);
  }
  return kept;
}

static int numbers_lighting(const LightColumns& l, int count, const PixelBounds* parts, int part_count, const int* light, int* numbers) {
  Sphere spheres[RELUME_CELL_PARTS];
  if (l.any_cone)
    for (int p = 0; p < part_count; ++p) spheres[p] = around(parts[p]);
  int kept = 0;
  for (int i = 0; i < count; i += RELUME_LANES) {
    mask lights = all_lanes(1.0f) < 0.0f;
    for (int p = 0; p < part_count; ++p) {
      mask some = is_near(l, i, parts[p]) & is_in_front(l, i, parts[p]);
      if (l.any_cone) some = some & cone_meets(l, i, spheres[p]);
      lights = lights | some;
    }
    for (unsigned bits = bits_of(lights); bits != 0; bits &= bits - 1) numbers[kept++] = light[i + __builtin_ctz(bits)];
  }
  return kept;
}
