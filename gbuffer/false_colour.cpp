// Colours: Okabe and Ito 2008 for names, viridis (Smith and van der Walt 2015) for numbers.
#include "gbuffer/false_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>

#include "gbuffer/ailments/row.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/printable.h"
#include "gbuffer/sample_rows.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

using Colour = RgbCode;
using Components = std::vector<const float*>;
using Painter = std::function<Colour(const Components& components, std::size_t i)>;

constexpr Colour vermillion{213, 94, 0}, sky_blue{86, 180, 233}, nothing = no_surface_colour;

/// 0..1; of NaN, which a range without extent leaves, 0: it has no code.
double within_range(double share) { return share > 0 ? std::min(share, 1.0) : 0; }

std::uint8_t code(double share) { return std::uint8_t(std::lround(255 * within_range(share))); }

Colour viridis(double share) {
  static constexpr std::array<Colour, 9> steps{
      {{68, 1, 84}, {71, 44, 122}, {59, 81, 139}, {44, 113, 142}, {33, 144, 141}, {39, 173, 129}, {92, 200, 99}, {170, 220, 50}, {253, 231, 37}}};
  const double at = within_range(share) * (steps.size() - 1);
  const std::size_t k = std::min<std::size_t>(std::size_t(at), steps.size() - 2);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) colour[c] = std::uint8_t(std::lround(steps[k][c] + (at - double(k)) * (steps[k + 1][c] - steps[k][c])));
  return colour;
}

/// Eight hues in three shades by a hash: neighbours in number are seldom alike.
Colour colour_of_id(std::uint32_t id) {
  static constexpr std::array<Colour, 8> hues{
      {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {213, 94, 0}, {204, 121, 167}, {200, 200, 200}}};
  if (id == 0) return nothing;
  const std::uint32_t hash = id * 2654435769u;  // 2^32 / golden ratio (Knuth, vol. 3, 6.4)
  const double shade = 1 - 0.25 * ((hash >> 16) % 3);
  Colour colour = hues[(hash >> 24) % hues.size()];
  for (std::uint8_t& c : colour) c = std::uint8_t(c * shade);
  return colour;
}

/// Where most of the finite values of a role's component lie, those that are 0 (background) aside.
struct Range {
  double low = 0, high = 1;
};

Range range_of(const std::vector<SampledBand>& bands, const std::string& role, std::size_t component, std::size_t components, double farthest) {
  std::vector<float> values;
  for (const SampledBand& band : bands) {
    const std::vector<float>& plane = band.planes.at(role);
    for (std::size_t i = component; i < plane.size(); i += components)
      if (std::isfinite(plane[i]) && plane[i] != 0 && std::abs(plane[i]) < farthest) values.push_back(plane[i]);
  }
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values[values.size() / 50], values[values.size() - 1 - values.size() / 50]};  // all but 2 % at each end
}

/// 1, 2 or 5 times a power of ten, at most `size`.
double round_step(double size) {
  if (!(size > 0) || !std::isfinite(size)) return 1;
  const double ten = std::pow(10.0, std::floor(std::log10(size)));
  return size >= 5 * ten ? 5 * ten : size >= 2 * ten ? 2 * ten : ten;
}

struct Style {
  Painter paint;
  std::string legend;
};

Style direction(const Reading& reading) {
  return {[frame = LayerFrame(reading)](const Components& v, std::size_t i) -> Colour {
            const glm::dvec3 n = frame.decoded({v[0][i], v[1][i], v[2][i]});
            if (n == glm::dvec3(0)) return nothing;
            return direction_colour(n.x, n.y, n.z);
          },
          "rgb = xyz"};
}

/// Each axis rises and falls: red, green and blue bands run across x, y and z.
Style place(const std::vector<SampledBand>& bands, const std::string& role) {
  double extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Range range = range_of(bands, role, c, 3, 1e30);
    extent = std::max(extent, range.high - range.low);
  }
  const double step = round_step(extent / 4);
  return {[step](const Components& v, std::size_t i) -> Colour {
            if (v[0][i] == 0 && v[1][i] == 0 && v[2][i] == 0) return nothing;
            Colour colour;
            for (std::size_t c = 0; c < 3; ++c) colour[c] = code(0.15 + 0.85 * std::abs(2 * (v[c][i] / step - std::floor(v[c][i] / step)) - 1));
            return colour;
          },
          "bands of " + three_digits(step) + ", rgb = xyz"};
}

Style distance(const std::vector<SampledBand>& bands, const std::string& role, double farthest) {
  const Range range = range_of(bands, role, 0, 1, farthest);
  const double low = std::max(std::abs(range.low), 1e-30), high = std::max(std::abs(range.high), low * 1.0001);
  return {[=](const Components& v, std::size_t i) -> Colour {
            const double depth = std::abs(double(v[0][i]));
            if (depth == 0 || depth >= farthest) return nothing;
            return viridis(1 - std::log(depth / low) / std::log(high / low));
          },
          three_digits(high) + " dark .. " + three_digits(low) + ", log"};
}

Style number(const std::vector<SampledBand>& bands, const std::string& role) {
  Range range = range_of(bands, role, 0, 1, 1e30);
  if (range.low >= 0 && range.high <= 1) range = {0, 1};
  if (!(range.high > range.low)) range.high = range.low + 1;
  return {[range](const Components& v, std::size_t i) { return viridis((v[0][i] - range.low) / (range.high - range.low)); },
          three_digits(range.low) + " dark .. " + three_digits(range.high)};
}

Style ids(SampleType type) {
  return {[type](const Components& v, std::size_t i) -> Colour {
            std::uint32_t id = 0;
            if (type == SampleType::uint32)
              std::memcpy(&id, v[0] + i, sizeof id);
            else if (v[0][i] > 0 && v[0][i] < 4294967040.0f)
              id = std::uint32_t(std::lround(v[0][i]));
            return colour_of_id(id);
          },
          "a colour for each"};
}

Style colour() {
  return {[](const Components& v, std::size_t i) { return Colour{srgb_code(v[0][i]), srgb_code(v[1][i]), srgb_code(v[2][i])}; }, "sRGB"};
}

Style coordinates() {
  return {[](const Components& v, std::size_t i) {
            return v[0][i] == 0 && v[1][i] == 0 ? nothing : Colour{code(v[0][i]), 60, code(v[1][i])};
          },
          "red u, blue v"};
}

Style style_of(const Reading& reading, const std::vector<SampledBand>& bands, const std::string& role) {
  const RoleLayer& layer = reading.roles.at(role);
  const std::size_t components = layer.channels.size();
  if (role == "ids") return ids(layer.types.front());
  if (components == 1) return role == "depth" ? distance(bands, role, reading.background_depth) : number(bands, role);
  if (components == 2) return coordinates();
  if (role == "position") return place(bands, role);
  if (role == "normal" || role == "base_normal" || role == "tangent") return direction(reading);
  return colour();
}

/// Letters, digits and '_' of a role: names of layers may hold anything.
std::string file_name_of(const std::string& role) {
  std::string name;
  for (const char c : role) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

CodedPicture blank(const Window& data) {
  const int step = view_step(data), width = (data.width() + step - 1) / step, height = (data.height() + step - 1) / step;
  return {width, height, 3, std::vector<unsigned char>(std::size_t(width) * std::size_t(height) * 3)};
}

void paint_row(const DecodedRows& band, const Window& data, int y, const std::string& role, bool numbers, const Style& style, CodedPicture& picture) {
  Components components;
  for (int c = 0; const float* const row = band.row(role, c, y); ++c) components.push_back(row);
  const int step = view_step(data);
  unsigned char* to = picture.codes.data() + std::size_t(y - data.min_y) / std::size_t(step) * std::size_t(picture.width) * 3;
  for (std::size_t i = 0; i < std::size_t(data.width()); i += std::size_t(step), to += 3) {
    const bool finite = !numbers || std::all_of(components.begin(), components.end(), [i](const float* v) { return std::isfinite(v[i]); });
    const Colour painted = finite ? style.paint(components, i) : vermillion;
    std::copy(painted.begin(), painted.end(), to);
  }
}

}  // namespace

int view_step(const Window& data) { return (std::max(data.width(), data.height()) + longest_view - 1) / longest_view; }

std::vector<View> false_colour_views(const ExrFile& file, const Reading& reading) {
  const Window& data = reading.data_window;
  std::vector<std::string> roles;
  for (const auto& [role, layer] : reading.roles) roles.push_back(role);
  std::vector<View> views;
  std::vector<Style> styles;
  const std::vector<SampledBand> bands = sample_rows(file, reading, roles);
  for (const std::string& role : roles) {
    styles.push_back(style_of(reading, bands, role));
    const std::string shown = role.starts_with("layer ") ? "" : role + ": ";
    views.push_back({file_name_of(role), shown + printable(reading.roles.at(role).layer) + ", " + styles.back().legend, blank(data)});
  }
  constexpr int rows = 256;  // every codec's blocks fit
  for (int top = data.min_y; top < data.max_y; top += rows) {
    const Window window{data.min_x, top, data.max_x, std::min(top + rows, data.max_y)};
    const DecodedRows band(file, reading, roles, window);
    for (std::size_t k = 0; k < roles.size(); ++k)
      for (int y = top; y < window.max_y; ++y)
        if ((y - data.min_y) % view_step(data) == 0)
          paint_row(band, data, y, roles[k], reading.roles.at(roles[k]).types.front() != SampleType::uint32, styles[k], views[k].picture);
  }
  return views;
}

RgbCode direction_colour(double x, double y, double z) { return {code(0.5 + 0.5 * x), code(0.5 + 0.5 * y), code(0.5 + 0.5 * z)}; }

RgbCode cosine_colour(double cosine) { return cosine < 0 ? vermillion : viridis(cosine); }

View marked_view(const View& under, const Window& data, const std::vector<std::uint8_t>& marks, const std::vector<bool>& defect) {
  View view{"findings", "findings: defects orange, hints blue", under.picture};
  const int step = view_step(data);
  for (int y = 0; y < under.picture.height; ++y)
    for (int x = 0; x < under.picture.width; ++x) {
      unsigned char* const to = view.picture.codes.data() + (std::size_t(y) * std::size_t(under.picture.width) + std::size_t(x)) * 3;
      std::uint8_t mark = 0;  // a single bad pixel must not fall between those that are shown
      for (int v = y * step; v < std::min((y + 1) * step, data.height()); ++v)
        for (int u = x * step; u < std::min((x + 1) * step, data.width()); ++u)
          if (const std::uint8_t own = marks[std::size_t(v) * std::size_t(data.width()) + std::size_t(u)]; own && (!mark || defect[own])) mark = own;
      const std::uint8_t grey = std::uint8_t((to[0] + to[1] + to[2]) / 9);
      const Colour painted = mark == 0 ? Colour{grey, grey, grey} : defect[mark] ? vermillion : sky_blue;
      std::copy(painted.begin(), painted.end(), to);
    }
  return view;
}

}  // namespace relume
