// bake: the pixels band by band, then vertices and facets in rows of at most 4096.
#include "bake/bake.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "bake/baked_columns.h"
#include "bake/baked_header.h"
#include "bake/tracer.h"
#include "bake/turn_to_viewer.h"
#include "bake/viewing_rays.h"
#include "gbuffer/error.h"
#include "gbuffer/mesh_parts.h"
#include "gbuffer/write_parts.h"

namespace relume {
namespace {

constexpr std::int64_t band_pixels = 1 << 18;  // some 25 MB of columns: enough for all cores, whatever the frame's size

/// A list as a picture, of rows that every reader takes.
Window window_of_list(std::size_t count) {
  constexpr std::size_t longest_row = 4096;
  const std::size_t width = std::clamp<std::size_t>(count, 1, longest_row);
  return {0, 0, int(width), int((count + width - 1) / width)};
}

/// One part of the file: `fill` gives pixel i of it, or false where there is nothing.
struct BakedPart {
  std::string name;
  Window window;
  std::vector<BakedColumn> columns;
  std::function<bool(std::int64_t i, BakedSample& sample)> fill;
};

class Baking {
 public:
  Baking(Mesh mesh, const BakeJob& job, const std::function<void(double)>& progress)
      : rays_(job.camera, {0, 0, job.width, job.height}), mesh_(turned(std::move(mesh))), job_(job), progress_(progress), tracer_(mesh_) {}

  BakeSummary run();

 private:
  Mesh turned(Mesh mesh) const {
    turn_to_viewer(mesh, rays_);
    return mesh;
  }
  BakedPart pixels();
  BakedPart vertices() const;
  BakedPart facets() const;
  void write(PartsWriter& writer, const std::vector<BakedPart>& parts, std::size_t index);

  const ViewingRays rays_;
  const Mesh mesh_;
  const BakeJob& job_;
  const std::function<void(double)>& progress_;
  const Tracer tracer_;
  std::atomic<std::int64_t> surface_pixels_ = 0;
};

BakedPart Baking::pixels() {
  const auto fill = [this](std::int64_t i, BakedSample& sample) {
    const bool from_behind = rays_.orthographic() && job_.camera.recovered;  // where along its axis such a camera stands, nobody knows
    const Hit hit = tracer_.nearest(rays_.through(int(i % job_.width), int(i / job_.width)), from_behind);
    if (hit.triangle < 0) return false;
    sample.point = surface_at(mesh_, mesh_.triangles[std::size_t(hit.triangle)], hit.barycentrics);
    sample.depth = hit.distance;
    sample.triangle = std::uint32_t(hit.triangle);
    sample.u = hit.barycentrics.y;
    sample.v = hit.barycentrics.z;
    surface_pixels_.fetch_add(1, std::memory_order_relaxed);
    return true;
  };
  return {"main", {0, 0, job_.width, job_.height}, pixel_columns(mesh_, job_.format.type == SampleType::half_float), fill};
}

BakedPart Baking::vertices() const {
  struct Use {
    std::int64_t triangle = -1;
    int corner = 0;
  };
  std::vector<Use> uses(mesh_.vertices.size());
  for (std::size_t t = mesh_.triangles.size(); t-- > 0;)
    for (int k = 0; k < 3; ++k) uses[mesh_.triangles[t].vertices[std::size_t(k)]] = {std::int64_t(t), k};
  const auto fill = [this, uses = std::move(uses)](std::int64_t i, BakedSample& sample) {
    if (std::size_t(i) >= uses.size() || uses[std::size_t(i)].triangle < 0) return false;  // the row's rest, and what no triangle uses
    glm::dvec3 weights(0);
    weights[uses[std::size_t(i)].corner] = 1;
    sample.point = surface_at(mesh_, mesh_.triangles[std::size_t(uses[std::size_t(i)].triangle)], weights);
    return true;
  };
  return {vertices_part, window_of_list(mesh_.vertices.size()), surface_columns(mesh_, job_.format.type == SampleType::half_float), fill};
}

BakedPart Baking::facets() const {
  const auto fill = [this](std::int64_t i, BakedSample& sample) {
    if (std::size_t(i) >= mesh_.triangles.size()) return false;
    const MeshTriangle& triangle = mesh_.triangles[std::size_t(i)];
    sample.point = surface_at(mesh_, triangle, glm::dvec3(1.0 / 3));
    sample.point.normal = sample.point.geometric_normal;  // a facet is flat
    sample.vertices = triangle.vertices;
    return true;
  };
  return {facets_part, window_of_list(mesh_.triangles.size()), facet_columns(mesh_, job_.format.type == SampleType::half_float), fill};
}

void Baking::write(PartsWriter& writer, const std::vector<BakedPart>& parts, std::size_t index) {
  const BakedPart& part = parts[index];
  const std::int64_t width = part.window.width();
  const int rows_at_once = int(std::clamp<std::int64_t>(band_pixels / width, 1, part.window.height()));
  for (int top = 0, rows = 0; top < part.window.max_y; top += rows) {
    rows = std::min(rows_at_once, part.window.max_y - top);
    BakedBand band(part.columns, std::size_t(rows * width));
    constexpr std::int64_t grain = 256;  // pixels: some 0.1 ms
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, rows * width, grain), [&](const tbb::blocked_range<std::int64_t>& some) {
      for (std::int64_t i = some.begin(); i < some.end(); ++i)
        if (BakedSample sample; part.fill(top * width + i, sample)) band.put(std::size_t(i), sample);
    });
    writer.write_rows(index, rows, band.samples());
    progress_((double(index) + double(top + rows) / part.window.height()) / double(parts.size()));
  }
}

BakeSummary Baking::run() {
  const std::vector<BakedPart> all{pixels(), vertices(), facets()};
  std::vector<OutputPart> described;
  for (const BakedPart& part : all) {
    described.push_back({part.name, part.window, {}, {}});
    for (const BakedColumn& column : part.columns) described.back().channels.push_back(column.channel);
  }
  described.front().attributes = header_of(job_, mesh_);
  PartsWriter writer(job_.output, job_.format.compression, job_.format.overwrite, all.front().window, described);
  for (std::size_t p = 0; p < all.size(); ++p) write(writer, all, p);
  writer.commit();
  return {surface_pixels_, std::int64_t(mesh_.triangles.size()), std::int64_t(mesh_.vertices.size())};
}

/// What the reader will take: gbuffer/exr_file.h.
void check_size(const BakeJob& job, const Mesh& mesh) {
  const ReadLimits limits;
  const std::string size = std::to_string(job.width) + "x" + std::to_string(job.height);
  if (job.width < 1 || job.height < 1 || job.width > limits.max_side || job.height > limits.max_side)
    throw Error(ErrorKind::input, "--size " + size + ": is not WxH, each from 1 to " + std::to_string(limits.max_side));
  const std::int64_t bytes = 4 * std::int64_t(pixel_columns(mesh, false).size()) * job.width * job.height;
  if (bytes > limits.max_decoded_bytes)
    throw Error(ErrorKind::input,
                "--size " + size + ": is " + std::to_string(bytes) + " bytes of pixels (at most " + std::to_string(limits.max_decoded_bytes) + ")");
}

}  // namespace

BakeSummary bake(Mesh mesh, const BakeJob& job, const std::function<void(double)>& progress) {
  check_size(job, mesh);
  return Baking(std::move(mesh), job, progress).run();
}

}  // namespace relume
