// add_patches: pixels with their shading normals, sorted by program, split at the widest gaps.
#include "host/pixel_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace relume {
namespace {

constexpr std::size_t fewest = 4;  ///< pixels that are worth a patch of their own
constexpr int most_splits = 4;     ///< one after another: sixteen patches at most
constexpr float wide = 0.3f;       ///< a gap is this share of the extent

struct Pixel {
  int at, program;
  bool highlights;
  float p[3], n[3], v[3], n_v;
};

float dot(const float* a, const float* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// One value of a field for pixel i.
float value_of(const Planes& planes, const Field& field, int component, int i) {
  return planes
      .data()[std::size_t(field.offset) + std::size_t(component) * std::size_t(field.component_step) + std::size_t(field.step) * std::size_t(i)];
}

void to_viewer(const Frame& frame, Pixel& pixel) {
  float length2 = 0;
  for (int c = 0; c < 3; ++c) pixel.v[c] = frame.viewer[c] - frame.viewer[3] * pixel.p[c], length2 += pixel.v[c] * pixel.v[c];
  const float scale = 1 / std::sqrt(length2);
  for (float& v : pixel.v) v *= scale;
}

void add_pixel(const PixelCells& cells, int i, std::vector<Pixel>& pixels) {
  const Planes& planes = cells.planes();
  const Frame& frame = cells.frame();
  const float program = planes.plane(frame.program_plane)[i];
  if (program < 0) return;
  Pixel pixel{};
  pixel.at = i, pixel.program = int(program);
  for (int c = 0; c < 3; ++c) pixel.p[c] = planes.plane(frame.position + c)[i], pixel.n[c] = planes.plane(frame.normal + c)[i];
  to_viewer(frame, pixel);
  pixel.n_v = dot(pixel.n, pixel.v);
  const float facing = value_of(planes, frame.field[FIELD_facing], 0, i);
  // Within this of the horizon rounding decides which side is shaded, and both are bounded.
  constexpr float unsure = 1e-5f;
  const bool two_sided = facing == float(FACING_two_sided);
  const auto add_side = [&](float sign) {
    Pixel side = pixel;
    for (float& n : side.n) n *= sign;
    side.n_v *= sign;
    side.highlights = side.n_v > -unsure;
    if (side.highlights || facing == float(FACING_as_stored)) pixels.push_back(side);
  };
  if (!two_sided || pixel.n_v > -unsure) add_side(1);
  if (two_sided && pixel.n_v < unsure) add_side(-1);
}

/// Around the mean of unit vectors; the slack covers what rounding makes of both.
DirectionCone cone_of(std::span<const Pixel> pixels, const float (Pixel::*direction)[3]) {
  DirectionCone cone{};
  for (const Pixel& pixel : pixels)
    for (int c = 0; c < 3; ++c) cone.axis[c] += (pixel.*direction)[c];
  const float length = std::sqrt(dot(cone.axis, cone.axis));
  if (!(length > 0.01f * float(pixels.size()))) return {{0, 0, 1}, -1, 0};  // all directions
  for (float& a : cone.axis) a /= length;
  float chord2 = 0;
  for (const Pixel& pixel : pixels) {
    float apart2 = 0;
    for (int c = 0; c < 3; ++c) apart2 += ((pixel.*direction)[c] - cone.axis[c]) * ((pixel.*direction)[c] - cone.axis[c]);
    chord2 = std::max(chord2, apart2);
  }
  chord2 = std::min(4.0f, 1.001f * chord2 + 1e-10f);
  cone.cosine = 1 - 0.5f * chord2;
  cone.sine = std::sqrt(chord2 * (1 - 0.25f * chord2));
  return cone;
}

void bound_positions(std::span<const Pixel> pixels, PixelPatch& patch) {
  float low[3], high[3], radius2 = 0;
  for (int c = 0; c < 3; ++c) {
    const auto [least, most] = std::minmax_element(pixels.begin(), pixels.end(), [c](const Pixel& a, const Pixel& b) { return a.p[c] < b.p[c]; });
    low[c] = least->p[c], high[c] = most->p[c];
    patch.centre[c] = 0.5f * (low[c] + high[c]);
  }
  for (const Pixel& pixel : pixels) {
    float apart2 = 0;
    for (int c = 0; c < 3; ++c) apart2 += (pixel.p[c] - patch.centre[c]) * (pixel.p[c] - patch.centre[c]);
    radius2 = std::max(radius2, apart2);
  }
  patch.radius = 1.0001f * std::sqrt(radius2);
}

void bound_parameters(const PixelCells& cells, std::span<const Pixel> pixels, PixelPatch& patch) {
  for (int f = 0; f < FIELD_COUNT; ++f) {
    const Field& field = cells.frame().field[f];
    for (int c = 0; c < 3; ++c) {
      float& low = patch.low[f][c] = std::numeric_limits<float>::infinity();
      float& high = patch.high[f][c] = -low;
      for (const Pixel& pixel : pixels) {
        const float value = value_of(cells.planes(), field, c, pixel.at);
        low = std::min(low, value), high = std::max(high, value);
        if (field.step == 0) break;
      }
    }
  }
}

void add_patch(const PixelCells& cells, std::span<const Pixel> pixels, std::vector<PixelPatch>& patches) {
  PixelPatch patch{};
  patch.program = pixels.front().program, patch.highlights = pixels.front().highlights;
  bound_positions(pixels, patch);
  patch.normal = cone_of(pixels, &Pixel::n);
  patch.view = cone_of(pixels, &Pixel::v);
  const auto [least, most] = std::minmax_element(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) { return a.n_v < b.n_v; });
  patch.n_v_low = least->n_v, patch.n_v_high = most->n_v;
  bound_parameters(cells, pixels, patch);
  patches.push_back(patch);
}

/// The coordinate in which the pixels are spread most, and how far.
std::pair<int, float> widest(std::span<const Pixel> pixels, const float (Pixel::*place)[3]) {
  std::pair<int, float> found{0, 0.0f};
  for (int c = 0; c < 3; ++c) {
    const auto [least, most] =
        std::minmax_element(pixels.begin(), pixels.end(), [&](const Pixel& a, const Pixel& b) { return (a.*place)[c] < (b.*place)[c]; });
    if (const float extent = ((*most).*place)[c] - ((*least).*place)[c]; extent > found.second) found = {c, extent};
  }
  return found;
}

/// Sorts them along a coordinate. Where the widest gap is, and how wide.
std::pair<std::size_t, float> sort_and_find_gap(std::span<Pixel> pixels, const float (Pixel::*place)[3], int c) {
  std::sort(pixels.begin(), pixels.end(), [&](const Pixel& a, const Pixel& b) { return (a.*place)[c] < (b.*place)[c]; });
  std::pair<std::size_t, float> found{pixels.size() / 2, 0.0f};
  for (std::size_t i = 1; i < pixels.size(); ++i)
    if (const float gap = (pixels[i].*place)[c] - (pixels[i - 1].*place)[c]; gap > found.second) found = {i, gap};
  return found;
}

/// Where they fall apart in space, or face too many ways. pixels.size() where they do neither.
std::size_t find_split(std::span<Pixel> pixels, float most_turn) {
  const auto [axis, extent] = widest(pixels, &Pixel::p);
  if (const auto [place, gap] = sort_and_find_gap(pixels, &Pixel::p, axis); gap > wide * extent) return place;
  const auto [way, turn] = widest(pixels, &Pixel::n);
  if (!(turn > most_turn)) return pixels.size();
  const auto [place, gap] = sort_and_find_gap(pixels, &Pixel::n, way);
  return gap > wide * turn ? place : pixels.size() / 2;
}

void split(const PixelCells& cells, std::span<Pixel> pixels, float most_turn, int splits, std::vector<PixelPatch>& patches) {
  const std::size_t place = splits < most_splits && pixels.size() >= fewest ? find_split(pixels, most_turn) : pixels.size();
  if (place == pixels.size()) return add_patch(cells, pixels, patches);
  split(cells, pixels.first(place), most_turn, splits + 1, patches);
  split(cells, pixels.subspan(place), most_turn, splits + 1, patches);
}

}  // namespace

void add_patches(const PixelCells& cells, int y, int column, int rows, float most_turn, std::vector<PixelPatch>& patches) {
  thread_local std::vector<Pixel> pixels;
  pixels.clear();
  for (int row = y; row < y + rows; ++row)
    if (const int block = cells.block_at(row, column); block >= 0)
      for (int i = block * PixelCells::block; i < std::min((block + 1) * PixelCells::block, cells.frame().pixels); ++i) add_pixel(cells, i, pixels);
  const auto kind = [](const Pixel& pixel) { return 2 * pixel.program + int(pixel.highlights); };
  std::stable_sort(pixels.begin(), pixels.end(), [&](const Pixel& a, const Pixel& b) { return kind(a) < kind(b); });
  for (std::size_t first = 0; first < pixels.size();) {
    std::size_t last = first + 1;
    while (last < pixels.size() && kind(pixels[last]) == kind(pixels[first])) ++last;
    split(cells, std::span(pixels).subspan(first, last - first), most_turn, 0, patches);
    first = last;
  }
}

}  // namespace relume
