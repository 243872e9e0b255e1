// Telling pure pixels from mixed ones.
#include "gbuffer/filtered_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>

#include "gbuffer/cryptomatte.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/sample_rows.h"
#include "gbuffer/samples.h"

namespace relume {
namespace {

constexpr int filter_radius = 2;         // pixels: the widest that renderers ship as a default
constexpr double shows_nothing = 1e-4;   // gaussian tails leak 1e-11 into their surroundings
constexpr double short_of_one = 0.985;   // the normals of a ball of 20 pixels' radius differ that much within a filter
constexpr double whole_id = 1e-3;        // relative: what single precision and rounding of weights leave of a whole number
constexpr double full_coverage = 0.999;  // half precision next to 1

/// Takes stored normals to where stored positions live; what cannot be told is left alone.
glm::dmat3 normal_to_position(const Reading& reading) {
  const glm::dmat3 normal = matrix_of(reading.normal_axes), back = glm::transpose(matrix_of(reading.position_axes));
  if (reading.normal_space == reading.position_space || !reading.camera) return back * normal;
  glm::dmat3 world_from_layer(reading.camera->world_from_camera);
  return back * (reading.normal_space == Space::camera ? world_from_layer : glm::transpose(world_from_layer)) * normal;
}

}  // namespace

bool whole_number(double id) { return std::abs(id - std::round(id)) <= whole_id * std::max(1.0, std::round(id)); }

FilteredLayers::FilteredLayers(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles)
    : window_(grown(window, reach + filter_radius, reading.data_window)), turn_(normal_to_position(reading)) {
  constexpr double of_directions = 0.01, of_numbers = 0.01, of_ids = 0.02, of_alpha = 2e-3, of_places = 1e-3;
  const bool all = reading.position_premultiplied;
  const Mean directions = reading.mean_over_hits ? Mean::direction : Mean::over_pixel;
  const Mean places = all ? Mean::over_pixel : reading.mean_over_hits ? Mean::over_hits : Mean::none;
  const bool fractions = reading.roles.contains("ids") && reading.roles.at("ids").types.front() != SampleType::uint32;
  add(reading, "normal", directions, of_directions);
  add(reading, "position", places, of_places, true);
  add(reading, "base_normal", directions, of_directions);
  add(reading, "ids", all && fractions ? Mean::over_pixel : Mean::none, of_ids);
  add(reading, "coverage", Mean::over_pixel, of_alpha);
  add(reading, "depth", Mean::none, of_places, true);
  for (const std::string& role : roles)
    if (!role.starts_with(cryptomatte_role)) add(reading, role, Mean::over_pixel, of_numbers);  // ids' bits are no numbers
  position_ = layer("position"), ids_ = layer("ids"), alpha_ = layer("coverage"), depth_ = layer("depth");
  if (reading.normal_space == Space::view_ray) position_ = nullptr;  // a frame for each pixel: normals and chords do not compare
  read(file, reading);
  const std::size_t pixels = std::size_t(window_.pixels());
  kinds_.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) kinds_[i] = kind_by_itself(reading, i);
  if (places != Mean::none && position_) settle_by_neighbours(reading.mean_over_hits);
}

/// A mean of two positions lies on neither surface, though normals and ids may be alike. Means over hits do not tell background by themselves.
void FilteredLayers::settle_by_neighbours(bool mean_over_hits) {
  std::vector<Kind> settled = kinds_;
  for (int y = window_.min_y; y < window_.max_y; ++y)
    for (int x = window_.min_x; x < window_.max_x; ++x) {
      if (!pure(index(x, y))) continue;
      if (!in_a_block(x, y))
        settled[index(x, y)] = Kind::mixed;
      else if (mean_over_hits && (beside_background(x, y) || bends(x, y)))
        settled[index(x, y)] = Kind::fringe;
    }
  kinds_ = std::move(settled);
}

/// Normals that were made unit again do not tell a mean by their length, only by turning to the other surface's.
bool FilteredLayers::bends(int x, int y) const {
  constexpr double straight = 0.9;  // cosine: 26 degrees from a pixel to the next
  const std::size_t self = index(x, y);
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (inside(u, v) && pure(index(u, v)) && !(one_surface(self, index(u, v)) && glm::dot(normal(self), normal(index(u, v))) > straight))
        return true;
  return false;
}

bool FilteredLayers::beside_background(int x, int y) const {
  for (int v = y - filter_radius; v <= y + filter_radius; ++v)
    for (int u = x - filter_radius; u <= x + filter_radius; ++u)
      if (inside(u, v) && empty(index(u, v))) return true;
  return false;
}

void FilteredLayers::add(const Reading& reading, const std::string& role, Mean mean, double resolution, bool relative) {
  const auto found = reading.roles.find(role);
  if (found == reading.roles.end() || layer(role)) return;
  const int count = int(found->second.channels.size());
  const bool is_signed = role == "normal" || role == "base_normal" || role == "position" || role == "uv";
  layers_.push_back({role, components_, count, mean, resolution, relative, is_signed});
  components_ += count;
}

const FilteredLayers::Layer* FilteredLayers::layer(const std::string& role) const {
  const auto found = std::find_if(layers_.begin(), layers_.end(), [&](const Layer& l) { return l.role == role; });
  return found == layers_.end() ? nullptr : &*found;
}

void FilteredLayers::read(const ExrFile& file, const Reading& reading) {
  const std::size_t step = sizeof(float) * std::size_t(components_);
  values_.resize(std::size_t(window_.pixels()) * std::size_t(components_));
  std::map<int, std::vector<Destination>> by_part;
  for (const Layer& layer : layers_) {
    const RoleLayer& from = reading.roles.at(layer.role);
    for (int c = 0; c < layer.count; ++c)
      by_part[from.part].push_back(
          {from.channels[std::size_t(c)], SampleType::float32, values_.data() + layer.first + c, step, step * std::size_t(window_.width())});
  }
  for (const auto& [part, destinations] : by_part) file.read(part, window_, destinations);
  if (reading.normal_encoding == NormalEncoding::as_signed) return;
  for (const Layer& layer : layers_)
    if (layer.role == "normal" || layer.role == "base_normal")
      for (std::size_t i = 0; i < std::size_t(window_.pixels()); ++i) {
        float* const stored = values_.data() + i * std::size_t(components_) + std::size_t(layer.first);
        const glm::dvec3 decoded = decoded_normal(reading, {stored[0], stored[1], stored[2]});
        for (int c = 0; c < 3; ++c) stored[c] = float(decoded[c]);
      }
}

glm::dvec3 FilteredLayers::vector(const Layer& layer, std::size_t i) const {
  const float* const v = value(i) + layer.first;
  return {v[0], v[1], v[2]};
}

FilteredLayers::Kind FilteredLayers::kind_by_itself(const Reading& reading, std::size_t i) const {
  const float* const v = value(i);
  for (const Layer& layer : layers_)
    if (&layer != depth_ && !std::all_of(v + layer.first, v + layer.first + layer.count, [](float x) { return std::isfinite(x); }))
      return Kind::broken;
  const double length = glm::length(vector(layers_[0], i));
  const bool unit = std::abs(length - 1) < 1 - short_of_one;
  const bool far = depth_ && !(std::abs(v[depth_->first]) < reading.background_depth);
  if (length < shows_nothing || (far && unit)) return Kind::empty;
  const double alpha = alpha_ ? v[alpha_->first] : 1;
  const bool partial = alpha > shows_nothing && alpha < full_coverage;
  const bool fraction = ids_ && ids_->mean == Mean::over_pixel && !whole_number(v[ids_->first]);
  return unit && !partial && !fraction ? Kind::pure : Kind::mixed;
}

/// The chord between two points of a smooth surface is perpendicular to the sum of their normals (exactly so on a ball).
bool FilteredLayers::one_surface(std::size_t a, std::size_t b) const {
  if (ids_ && std::abs(value(a)[ids_->first] - value(b)[ids_->first]) > 0.5) return false;
  constexpr double alike = 0.5;                       // cosine: less is a crease
  constexpr double steepest = 0.25, rounding = 1e-3;  // facets under smooth normals lean that much; half precision, of the position
  const glm::dvec3 na = normal(a), nb = normal(b);
  if (!(glm::dot(na, nb) > alike)) return false;
  if (!position_) return true;
  const glm::dvec3 pa = vector(*position_, a), chord = vector(*position_, b) - pa;
  return std::abs(glm::dot(chord, glm::normalize(na + nb))) <= steepest * glm::length(chord) + rounding * glm::length(pa);
}

/// Some 2x2 block with it is one surface. Mixed pixels in a row along an edge resemble each other, but not across it.
bool FilteredLayers::in_a_block(int x, int y) const {
  for (const int dy : {-1, 1})
    for (const int dx : {-1, 1}) {
      if (!inside(x + dx, y + dy)) continue;
      const std::size_t self = index(x, y), a = index(x + dx, y), b = index(x, y + dy), c = index(x + dx, y + dy);
      if (pure(a) && pure(b) && pure(c) && one_surface(self, a) && one_surface(self, b) && one_surface(a, c) && one_surface(b, c)) return true;
    }
  return false;
}

void FilteredLayers::look(Steps& steps, std::vector<Sighting>& mixed_ones, std::vector<Sighting>& pure_ones) const {
  for (int y = window_.min_y; y < window_.max_y; ++y)
    for (int x = window_.min_x; x < window_.max_x; ++x) {
      const std::size_t i = index(x, y);
      steps.soft += kinds_[i] == Kind::mixed;
      if (inside(x + 1, y)) steps.hard += pure(i) && pure(index(x + 1, y)) && !one_surface(i, index(x + 1, y));
      if (mixed(i) && position_) mixed_ones.push_back({x + 0.5, y + 0.5, vector(*position_, i)});
      if (pure(i) && position_) pure_ones.push_back({x + 0.5, y + 0.5, vector(*position_, i)});
    }
}

namespace {

/// Means leave short normals or fractions of ids: a quick look that spares most files the closer one.
bool shows_means(const Reading& reading, const SampledBand& band) {
  for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
    const double length = glm::length(decoded_normal(reading, band.vector("normal", i)));
    if (length > shows_nothing && length < short_of_one) return true;
    if (band.has("ids") && !whole_number(band.value("ids", i))) return true;
  }
  return false;
}

/// The camera among the positions as they are stored.
std::optional<Camera> camera_of_positions(const Reading& reading) {
  std::optional<Camera> camera = reading.camera;
  if (!camera) return camera;
  const glm::dmat4 stored_from_ordered(glm::transpose(matrix_of(reading.position_axes)) / reading.position_scale);
  camera->world_from_camera = stored_from_ordered * (reading.position_space == Space::camera ? glm::dmat4(1.0) : camera->world_from_camera);
  return camera;
}

/// Pixels: how far all but a tenth of the sightings are from where the camera sees them at most.
double usual_miss(const Camera& camera, const std::vector<Sighting>& sightings) {
  std::vector<double> misses;
  for (const Sighting& s : sightings) misses.push_back(reprojection_error(camera, {s}));
  const auto rank = misses.begin() + std::ptrdiff_t(double(misses.size() - 1) * 0.9);
  std::nth_element(misses.begin(), rank, misses.end());
  return *rank;
}

/// Beside an edge the hits lie to one side of the pixel's centre, and so does their mean.
bool misses_centres(const Reading& reading, const std::vector<Sighting>& mixed, const std::vector<Sighting>& pure) {
  constexpr std::size_t too_few = 8;
  constexpr double noticeable = 0.03, clearly = 4;  // pixels: half precision misses by 0.01; and more than inside of surfaces
  auto camera = camera_of_positions(reading);
  if (!camera || mixed.size() < too_few || pure.size() < too_few) return false;
  camera->lens = fit_pose(*camera, pure).lens();
  return usual_miss(*camera, mixed) > std::max(noticeable, clearly * usual_miss(*camera, pure));
}

}  // namespace

bool looks_filtered(Samples& samples, const Reading& reading) {
  if (reading.normal_in_tangent_frame || is_made(reading, "normal")) return false;  // such normals do not tell surfaces apart
  const std::vector<SampledBand>& bands = samples.bands(reading);
  if (!reading.mean_over_hits && std::none_of(bands.begin(), bands.end(), [&](const SampledBand& band) { return shows_means(reading, band); }))
    return false;
  FilteredLayers::Steps steps;
  std::vector<Sighting> mixed, pure;
  for (const SampledBand& band : bands) FilteredLayers(samples.file(), reading, band.window, {}).look(steps, mixed, pure);
  return reading.mean_over_hits ? misses_centres(reading, mixed, pure) : steps.soft > steps.hard;
}

}  // namespace relume
