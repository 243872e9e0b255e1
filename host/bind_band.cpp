// Binding::bind: one band's program plane and parameter planes.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <tuple>

#include "gbuffer/error.h"
#include "host/binding.h"
#include "host/cycles_f0.h"
#include "host/lobes.h"
#include "host/texture.h"

namespace relume {
namespace {

using Pixel = std::int64_t;
constexpr Pixel grain = 1 << 14;  // pixels that one task takes: enough to hide the scheduler

template <class Body>
void for_pixels(Pixel pixels, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<Pixel>(0, pixels, grain), [&](const auto& range) {
    for (Pixel i = range.begin(); i < range.end(); ++i) body(i);
  });
}

/// One value for all pixels, kept in the band's plane of constants.
class Constants {
 public:
  explicit Constants(Planes& planes) : planes_(planes), plane_(planes.add()) {}
  Field place(const std::vector<double>& values) {
    const int offset = int(planes_.stride()) * plane_ + used_;
    for (const double value : values) planes_.plane(plane_)[used_++] = float(value);
    return {offset, 0, values.size() == 1 ? 0 : 1};
  }

 private:
  Planes& planes_;
  int plane_, used_ = 0;
};

std::vector<double> constant_of(const FieldSource& source) {
  std::vector<double> values = source.constant;
  for (double& value : values) value = source.converted(value);
  return values;
}

/// A field's source at work on one band: value(i, c).
class Reader {
 public:
  Reader(const GBuffer& gbuffer, const FieldSource& source, const Parameter& parameter) : planes_(gbuffer.planes), source_(source) {
    if (source.texture) {
      texture_ = &texture_of(*source.texture);
      range_ = gbuffer.roles.at(source.uv_role);
    } else if (!source.role.empty()) {
      range_ = gbuffer.roles.at(source.role);
      if (range_.count != 1 && range_.count < parameter.components)
        throw Error(ErrorKind::input, "layer \"" + source.role + "\" has " + std::to_string(range_.count) + " channels; " +
                                          std::string(parameter.name) + " takes 1 or " + std::to_string(parameter.components));
    }
  }

  float value(Pixel i, int c) const {
    double v = 0;
    if (texture_)
      v = texture_->sample(planes_.plane(range_.first)[i], planes_.plane(range_.first + 1)[i], c);
    else if (!source_.role.empty())
      v = planes_.plane(range_.first + (range_.count == 1 ? 0 : c))[i];
    else
      v = source_.constant[source_.constant.size() == 1 ? 0 : std::size_t(c)];
    return float(source_.converted(v));
  }

  /// The layer's own planes, if the field can read them as they are.
  std::optional<Field> in_place() const {
    if (texture_ || source_.role.empty() || source_.convert) return {};
    const int stride = int(planes_.stride());
    return Field{stride * range_.first, 1, range_.count == 1 ? 0 : stride};
  }

 private:
  const Planes& planes_;
  const FieldSource& source_;
  const Texture* texture_ = nullptr;
  PlaneRange range_;
};

}  // namespace

std::vector<int> Binding::materials_of_pixels(const GBuffer& gbuffer) const {
  const Pixel pixels = gbuffer.samples();
  std::vector<int> material(std::size_t(pixels), fallback_);
  if (!objects_) return material;
  std::set<std::uint32_t> unknown;
  const float* coverage = gbuffer.planes.plane(gbuffer.coverage.first);
  const std::vector<std::uint32_t> ids = objects_->most_covering(gbuffer);
  std::optional<std::uint32_t> last_id;
  int last = fallback_;
  for (Pixel i = 0; i < pixels; ++i) {
    if (coverage[i] <= 0) continue;
    const std::uint32_t id = ids[std::size_t(i)];
    if (id != last_id) {
      const auto found = by_id_.find(id);
      last_id = id;
      last = found == by_id_.end() ? fallback_ : found->second;
      if (last < 0) unknown.insert(id);
    }
    material[std::size_t(i)] = last;
  }
  if (!unknown.empty()) refuse_unknown(unknown);
  return material;
}

void Binding::refuse_unknown(const std::set<std::uint32_t>& ids) const {
  std::string list;
  for (const std::uint32_t id : ids)
    if (list.size() < 200)
      list += (list.empty() ? "" : ", ") + (objects_->is_cryptomatte() && id == 0 ? "(pixels that show none)" : objects_->called(id));
  const std::string object = objects_->is_cryptomatte() ? "object " : "object id ";
  throw Error(ErrorKind::input, place_ + ": no material for " + object + list + " (a \"default\" entry would take them)");
}

void Binding::fill_program_plane(GBuffer& gbuffer, const std::vector<int>& material, Frame& frame) const {
  frame.program_plane = gbuffer.planes.add();
  float* program = gbuffer.planes.plane(frame.program_plane);
  const float* coverage = gbuffer.planes.plane(gbuffer.coverage.first);
  for_pixels(gbuffer.samples(), [&](Pixel i) {
    const int m = material[std::size_t(i)];
    program[i] = coverage[i] > 0 && m >= 0 ? float(program_of_[std::size_t(m)]) : -1.0f;
  });
  std::fill(program + gbuffer.samples(), program + gbuffer.planes.stride(), -1.0f);
}

/// Replaces base colour, metallic and specular level by what GlossCol and DiffCol tell.
void Binding::solve_cycles_surfaces(GBuffer& gbuffer, const Camera& camera) const {
  const auto solved = std::find_if(materials_.begin(), materials_.end(), [](const BoundMaterial& m) { return m.solve_cycles; });
  if (solved == materials_.end()) return;
  const int first = gbuffer.planes.add(5);
  for (const auto& [role, offset, count] : {std::tuple{"solved:base_color", 0, 3}, {"solved:metallic", 3, 1}, {"solved:specular_level", 4, 1}})
    gbuffer.roles[role] = {first + offset, count};
  const bool multi = solved->choice.distribution == DISTRIBUTION_multi_ggx;
  const Reader roughness(gbuffer, solved->fields.at(FIELD_roughness), parameter_named("roughness"));
  const Planes& planes = gbuffer.planes;
  const float* coverage = planes.plane(gbuffer.coverage.first);
  const int gloss = gbuffer.roles.at("glossy_albedo").first, diffuse = gbuffer.roles.at("albedo").first;
  const bool orthographic = camera.projection == Camera::Projection::orthographic;
  for_pixels(gbuffer.samples(), [&](Pixel i) {
    if (coverage[i] <= 0) return;
    const auto three = [&](int plane) {
      return std::array<double, 3>{planes.plane(plane)[i], planes.plane(plane + 1)[i], planes.plane(plane + 2)[i]};
    };
    const auto vector = [&](int plane) { return glm::dvec3(three(plane)[0], three(plane)[1], three(plane)[2]); };
    const glm::dvec3 view = orthographic ? camera.backward() : glm::normalize(camera.eye() - vector(gbuffer.position.first));
    const double n_v = glm::dot(vector(gbuffer.normal.first), view);
    const CyclesSurface s = solve_cycles_surface(three(gloss), three(diffuse), roughness.value(i, 0), n_v, multi);
    for (int c = 0; c < 3; ++c) gbuffer.planes.plane(first + c)[i] = float(s.base_color[std::size_t(c)]);
    gbuffer.planes.plane(first + 3)[i] = float(s.metallic);
    gbuffer.planes.plane(first + 4)[i] = float(s.specular_level);
  });
}

namespace {

/// Where each material takes a parameter from.
std::vector<FieldSource> sources_of(const std::vector<BoundMaterial>& materials, const Parameter& parameter) {
  static const std::map<int, FieldSource> solved{{FIELD_base_color, {{}, "solved:base_color", {}, {}}},
                                                 {FIELD_metallic, {{}, "solved:metallic", {}, {}}},
                                                 {FIELD_specular_level, {{}, "solved:specular_level", {}, {}}}};
  const FieldSource fallback{{parameter.fallback}, {}, {}, {}};
  std::vector<FieldSource> sources;
  for (const BoundMaterial& m : materials) {
    const auto found = m.fields.find(parameter.field);
    const auto from_solution = m.solve_cycles ? solved.find(parameter.field) : solved.end();
    sources.push_back(from_solution != solved.end() ? from_solution->second : found == m.fields.end() ? fallback : found->second);
  }
  return sources;
}

/// A constant for all pixels, a layer's planes as they lie, or planes filled for each pixel's material.
Field field_of(const std::vector<FieldSource>& sources, const Parameter& parameter, const std::vector<int>& material, GBuffer& gbuffer,
               Constants& constants) {
  const auto same_constant = [&](const FieldSource& s) {
    return s.is_constant() && s.constant == sources[0].constant && s.convert == sources[0].convert;
  };
  if (std::all_of(sources.begin(), sources.end(), same_constant)) return constants.place(constant_of(sources[0]));
  std::vector<Reader> readers;
  for (const FieldSource& source : sources) readers.emplace_back(gbuffer, source, parameter);
  if (readers.size() == 1)
    if (const auto in_place = readers[0].in_place()) return *in_place;
  const int first = gbuffer.planes.add(parameter.components);
  for_pixels(gbuffer.samples(), [&](Pixel i) {
    const int m = material[std::size_t(i)];
    if (m < 0) return;
    for (int c = 0; c < parameter.components; ++c) gbuffer.planes.plane(first + c)[i] = readers[std::size_t(m)].value(i, c);
  });
  return {int(gbuffer.planes.stride()) * first, 1, int(gbuffer.planes.stride())};
}

Field facing_of(const std::vector<BoundMaterial>& materials, const std::vector<int>& material, GBuffer& gbuffer, Constants& constants) {
  const auto alike = [&](const BoundMaterial& m) { return m.facing == materials[0].facing; };
  if (std::all_of(materials.begin(), materials.end(), alike)) return constants.place({double(materials[0].facing)});
  const int plane = gbuffer.planes.add();
  for_pixels(gbuffer.samples(), [&](Pixel i) {
    const int m = material[std::size_t(i)];
    gbuffer.planes.plane(plane)[i] = m < 0 ? 0.0f : float(materials[std::size_t(m)].facing);
  });
  return {int(gbuffer.planes.stride()) * plane, 1, 0};
}

}  // namespace

void Binding::bind(GBuffer& gbuffer, const Camera& camera, Frame& frame) const {
  const std::vector<int> material = materials_of_pixels(gbuffer);
  fill_program_plane(gbuffer, material, frame);
  solve_cycles_surfaces(gbuffer, camera);
  Constants constants(gbuffer.planes);
  for (const Parameter& parameter : parameters())
    frame.field[parameter.field] = field_of(sources_of(materials_, parameter), parameter, material, gbuffer, constants);
  frame.field[FIELD_facing] = facing_of(materials_, material, gbuffer, constants);
  frame.field[FIELD_coverage] =
      gbuffer.fractional_coverage ? Field{int(gbuffer.planes.stride()) * gbuffer.coverage.first, 1, 0} : constants.place({1.0});
}

void Binding::bind_irradiance(GBuffer& gbuffer, Frame& frame) const {
  fill_program_plane(gbuffer, std::vector<int>(std::size_t(gbuffer.samples()), 0), frame);
  float* program = gbuffer.planes.plane(frame.program_plane);
  for_pixels(gbuffer.samples(), [&](Pixel i) { program[i] = std::min(program[i], 0.0f); });
  Constants constants(gbuffer.planes);
  for (const Parameter& parameter : parameters()) frame.field[parameter.field] = constants.place({parameter.fallback});
  frame.field[FIELD_albedo] = constants.place({std::numbers::pi});
  frame.field[FIELD_facing] = constants.place({double(Facing::as_stored)});
  frame.field[FIELD_coverage] = constants.place({1.0});
}

}  // namespace relume
