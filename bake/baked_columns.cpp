// Positions, depths, barycentrics and texture coordinates are always 32-bit: half precision would move them by more than a pixel.
#include "bake/baked_columns.h"

#include <bit>

#include "gbuffer/mesh_parts.h"

namespace relume {
namespace {

using Sample = const BakedSample&;

void add(std::vector<BakedColumn>& to, std::vector<BakedColumn> more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

std::vector<BakedColumn> surface_columns(const Mesh& mesh, bool halves) {
  const SampleType exact = SampleType::float32, whole = SampleType::uint32, value = halves ? SampleType::half_float : SampleType::float32;
  std::vector<BakedColumn> columns{{{"P.X", exact}, [](Sample s) { return s.point.position.x; }},
                                   {{"P.Y", exact}, [](Sample s) { return s.point.position.y; }},
                                   {{"P.Z", exact}, [](Sample s) { return s.point.position.z; }},
                                   {{"N.X", value}, [](Sample s) { return s.point.normal.x; }},
                                   {{"N.Y", value}, [](Sample s) { return s.point.normal.y; }},
                                   {{"N.Z", value}, [](Sample s) { return s.point.normal.z; }},
                                   {{"Ng.X", value}, [](Sample s) { return s.point.geometric_normal.x; }},
                                   {{"Ng.Y", value}, [](Sample s) { return s.point.geometric_normal.y; }},
                                   {{"Ng.Z", value}, [](Sample s) { return s.point.geometric_normal.z; }},
                                   {{"A", value}, [](Sample) { return 1.0; }},
                                   {{"id", whole}, [](Sample s) { return double(s.point.object); }}};
  if (mesh.has_uv) add(columns, {{{"uv.U", exact}, [](Sample s) { return s.point.uv.x; }}, {{"uv.V", exact}, [](Sample s) { return s.point.uv.y; }}});
  if (mesh.has_albedo)
    add(columns, {{{"albedo.R", value}, [](Sample s) { return s.point.albedo.x; }},
                  {{"albedo.G", value}, [](Sample s) { return s.point.albedo.y; }},
                  {{"albedo.B", value}, [](Sample s) { return s.point.albedo.z; }}});
  if (mesh.has_roughness) add(columns, {{{"roughness", value}, [](Sample s) { return s.point.roughness; }}});
  if (mesh.has_metallic) add(columns, {{{"metallic", value}, [](Sample s) { return s.point.metallic; }}});
  return columns;
}

std::vector<BakedColumn> pixel_columns(const Mesh& mesh, bool halves) {
  std::vector<BakedColumn> columns = surface_columns(mesh, halves);
  add(columns, {{{"Z", SampleType::float32}, [](Sample s) { return s.depth; }},
                {{facet_channel, SampleType::uint32}, [](Sample s) { return double(s.triangle); }},
                {{second_weight_channel, SampleType::float32}, [](Sample s) { return s.u; }},
                {{third_weight_channel, SampleType::float32}, [](Sample s) { return s.v; }}});
  return columns;
}

std::vector<BakedColumn> facet_columns(const Mesh& mesh, bool halves) {
  std::vector<BakedColumn> columns = surface_columns(mesh, halves);
  add(columns, {{{facet_vertex_channels[0], SampleType::uint32}, [](Sample s) { return double(s.vertices[0]); }},
                {{facet_vertex_channels[1], SampleType::uint32}, [](Sample s) { return double(s.vertices[1]); }},
                {{facet_vertex_channels[2], SampleType::uint32}, [](Sample s) { return double(s.vertices[2]); }}});
  return columns;
}

BakedBand::BakedBand(const std::vector<BakedColumn>& columns, std::size_t samples)
    : columns_(columns), bits_(columns.size(), std::vector<std::uint32_t>(samples)) {}

void BakedBand::put(std::size_t i, const BakedSample& sample) {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const double value = columns_[c].value(sample);
    bits_[c][i] = columns_[c].channel.type == SampleType::uint32 ? std::uint32_t(value) : std::bit_cast<std::uint32_t>(float(value));
  }
}

std::vector<const void*> BakedBand::samples() const {
  std::vector<const void*> all;
  for (const std::vector<std::uint32_t>& column : bits_) all.push_back(column.data());
  return all;
}

}  // namespace relume
