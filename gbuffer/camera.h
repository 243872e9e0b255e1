// The camera that a G-buffer was seen with: what shading needs of it, and where it came from.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/window.h"

namespace relume {

/// Where the image lies on the film: a point (x, y, -z) in camera space is seen at centre_x + scale_x x/z, centre_y - scale_y y/z, in pixels of
/// display-window coordinates (orthographic: without the division).
struct Lens {
  double scale_x, scale_y, centre_x, centre_y;
};

struct Camera {
  enum class Projection { perspective, orthographic };
  Projection projection = Projection::perspective;
  glm::dmat4 world_from_camera{1.0};  ///< columns: right, up, backward (the camera looks along its -z), eye. det < 0 in a left-handed world.
  double vertical_fov = 0;            ///< degrees, of the display window; 0: not known (shading does not need it)
  double height = 0;                  ///< orthographic: world units that the display window spans vertically; 0: not known
  std::optional<Lens> lens;           ///< where known: positions are made from depth with it
  bool assumed_lens = false;          ///< the lens was taken to be centred, with pixels as the header says: nothing tells it
  bool recovered = false;             ///< from the positions, rather than stated by a file
  std::string source;                 ///< for people: "worldToCamera of part 0", "recovered from Position", "rig.gltf"
  double residual = -1;               ///< median reprojection error in pixels, where it was measured; else negative
  double tolerance = 1;               ///< pixels: what rounded positions may leave of it

  glm::dvec3 eye() const { return glm::dvec3(world_from_camera[3]); }
  /// It is not the one that saw the positions.
  bool contradicted() const { return residual > tolerance; }
  /// The direction from the scene to the viewer (world), the same for all pixels of an orthographic camera; unit length.
  glm::dvec3 backward() const;
};

/// The camera's own lens, else the one that its field of view or height tells of this window; empty where neither is known.
/// `pixel_aspect`: width of a pixel over its height, as in OpenEXR's header.
std::optional<Lens> lens_of(const Camera& camera, const Window& display, double pixel_aspect);

/// The field of view or height that the lens gives the window; 0 where the optical axis is not at its centre.
void set_extent(Camera& camera, const Lens& lens, const Window& display);

/// A pixel's centre in display-window coordinates (x right, y down, pixel (0,0) has its centre at 0.5, 0.5) and its surface point.
struct Sighting {
  double x, y;
  glm::dvec3 position;
};

/// Median distance in pixels between where the camera's own lens shows each position and where it was seen. Infinite without a lens, or where half
/// of the positions lie behind the camera.
double reprojection_error(const Camera& camera, const std::vector<Sighting>& sightings);

/// How well a camera's place and axes explain the sightings, whatever its field of view and lens shift.
struct PoseFit {
  double residual;  ///< median reprojection error in pixels after the best scale and offset of each image axis; infinite: it looks the other way
  double centre_x, centre_y;  ///< where the optical axis meets the image, pixels
  double scale_y;             ///< pixels a unit of the tangent down the image; orthographic: pixels a world unit
  double scale_x;             ///< the same across

  Lens lens() const { return {scale_x, scale_y, centre_x, centre_y}; }
};
PoseFit fit_pose(const Camera& camera, const std::vector<Sighting>& sightings);

/// The lens that the fit found, if it is one, with the field of view or height that follows.
void set_extent(Camera& camera, const PoseFit& fit, const Window& display);

/// Finds the camera that sees each position at its pixel: perspective (also off-centre, non-square) or orthographic, with its lens.
/// Empty where the positions do not determine one (fewer than 8, all in one plane, residual above `max_residual` px).
std::optional<Camera> recover_camera(const std::vector<Sighting>& sightings, const Window& display, double max_residual = 1.0);

/// The same, with the reason where there is no camera ("all positions lie in one plane").
struct Recovery {
  std::optional<Camera> camera;
  std::string why_not;
  bool flat = false;  ///< because they lie in one plane, or nearly
};
Recovery recover(const std::vector<Sighting>& sightings, const Window& display, double max_residual = 1.0);

}  // namespace relume
