// Bands and rows: decoding each channel once, and telling surfaces from background as gbuffer.cpp does.
#include "gbuffer/ailments/row.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace relume {

using glm::dvec3;

DecodedRows::DecodedRows(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles, const Window& held) : window_(held) {
  std::map<int, std::map<std::string, std::size_t>> seen;
  std::map<int, std::vector<Destination>> by_part;
  const std::size_t width = std::size_t(held.width());
  for (const std::string& role : roles) {
    const auto found = reading.roles.find(role);
    if (found == reading.roles.end() || by_role_.contains(role)) continue;
    const RoleLayer& layer = found->second;
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      const auto [plane, is_new] = seen[layer.part].try_emplace(layer.channels[c], planes_.size());
      by_role_[role].push_back(plane->second);
      if (!is_new) continue;
      planes_.emplace_back(width * std::size_t(held.height()));
      // Whole numbers keep their bits: not every one of them is a float.
      const SampleType type = layer.types[c] == SampleType::uint32 ? SampleType::uint32 : SampleType::float32;
      by_part[layer.part].push_back({layer.channels[c], type, planes_.back().data(), sizeof(float), sizeof(float) * width});
    }
  }
  for (const auto& [part, destinations] : by_part) file.read(part, held, destinations);
}

const float* DecodedRows::row(const std::string& role, int component, int y) const {
  const auto found = by_role_.find(role);
  if (found == by_role_.end() || component >= int(found->second.size()) || y < window_.min_y || y >= window_.max_y) return nullptr;
  return planes_[found->second[std::size_t(component)]].data() + std::int64_t(y - window_.min_y) * window_.width();
}

Row::Row(const DecodedRows& from, const Reading& as_read, const LayerFrame& in_frame, int at)
    : reading(as_read), frame(in_frame), band(from), y(at), min_x(from.window().min_x), width(from.window().width()) {
  shown.assign(std::size_t(width), Shown::surface);
  length.assign(std::size_t(width), 1);
  place_surfaces();
  find_surfaces();
  find_mixtures();
}

std::vector<const float*> Row::components(const std::string& role) const {
  std::vector<const float*> all;
  for (int c = 0; const float* const row = stored(role, c); ++c) all.push_back(row);
  return all;
}

void Row::place_surfaces() {
  if (const auto p = components("position"); p.size() == 3) {
    place.resize(std::size_t(width));
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = frame.position_in_world({p[0][i], p[1][i], p[2][i]});
  }
  if (const auto n = components("normal"); n.size() == 3) {
    constexpr double no_direction = 1e-6;  // as in gbuffer.cpp: less is rounding, or a filter's tail
    normal.resize(std::size_t(width));
    for (std::size_t i = 0; i < normal.size(); ++i) {
      const dvec3 decoded = frame.decoded({n[0][i], n[1][i], n[2][i]});
      const double l = glm::length(decoded);
      length[i] = float(l);
      normal[i] = l > no_direction ? glm::normalize(frame.direction_in_world(decoded / l, place.empty() ? dvec3(0) : place[i])) : dvec3(0);
    }
  }
}

void Row::find_surfaces() {
  const float *const depth = stored("depth"), *const coverage = stored("coverage");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool lacks_normal = !normal.empty() && !(glm::dot(normal[i], normal[i]) > 0);
    const bool lacks_place = !place.empty() && !std::isfinite(place[i].x + place[i].y + place[i].z);
    const bool far = depth && !(std::abs(depth[i]) < reading.background_depth);
    if (lacks_normal || lacks_place || far || (coverage && !(coverage[i] > 0))) shown[i] = Shown::nothing;
  }
}

void Row::find_mixtures() {
  constexpr float whole = 0.999f, fraction = 0.01f;  // wider than what half precision and rounded weights leave
  const bool whole_ids = !reading.roles.contains("ids") || reading.roles.at("ids").types.front() == SampleType::uint32;
  const float *const coverage = stored("coverage"), *const ids = whole_ids ? nullptr : stored("ids");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool mixed = length[i] < 0.99f || (coverage && coverage[i] < whole) || (ids && std::abs(ids[i] - std::round(ids[i])) > fraction);
    if (mixed && shown[i] == Shown::surface) shown[i] = Shown::mixture;
  }
}

}  // namespace relume
