// A mesh and a camera in, a G-buffer out: the parts are the pixels, the mesh's vertices and its facets, so that a file lit later needs no mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "bake/mesh.h"
#include "gbuffer/camera.h"
#include "gbuffer/write_exr.h"

namespace relume {

struct BakeJob {
  std::filesystem::path output;
  Camera camera;
  int width = 0, height = 0;
  OutputFormat format;    ///< half: normals and colours; positions stay 32-bit
  std::string mesh_name;  ///< for the header
};

struct BakeSummary {
  std::int64_t surface_pixels = 0, triangles = 0, vertices = 0;
};

/// Every pixel's centre, whatever the number of threads. `progress` takes the share done. Throws Error; the output is whole or untouched.
BakeSummary bake(Mesh mesh, const BakeJob& job, const std::function<void(double)>& progress);

}  // namespace relume
