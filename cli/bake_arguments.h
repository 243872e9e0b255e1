// The options that say how a mesh is read and whence it is seen, shared by the commands that bake one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bake/read_mesh.h"
#include "gbuffer/camera.h"

namespace relume {

/// A camera and the size of its picture.
struct MeshView {
  Camera camera;
  int width = 0, height = 0;
};

struct BakeArguments {
  std::string camera, size, eye, target, normals, mesh_up, world_up;
  double fov = 0, height = 0;
  int usual_width = 1280, usual_height = 720;  ///< where neither --size nor the camera tells

  void add_to(CLI::App& command);
  /// Error{input} for options that contradict each other, or are no numbers; before any file is read.
  void check() const;
  MeshOptions mesh_options() const;
  /// What --camera names, --eye places, the mesh's file has, or else what frames the mesh; `notes` say which where nobody chose.
  MeshView view_of(const Mesh& mesh, const std::string& mesh_file, std::vector<std::string>& notes) const;

 private:
  Camera placed_camera(const Mesh& mesh) const;
  MeshView camera_from_file(const std::string& file) const;
  glm::dvec3 up() const;
};

}  // namespace relume
