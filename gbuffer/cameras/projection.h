// Cameras and lenses out of a matrix that takes the world to the image.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "gbuffer/camera.h"

namespace relume {

/// Column-vector matrix from 16 stored numbers; OpenEXR stores them for row vectors, pbrt the transpose of that.
glm::dmat4 matrix_of(const std::vector<double>& stored, bool transposed);

/// A rotation, perhaps mirrored and evenly scaled, and a translation.
bool rigid(const glm::dmat4& matrix);

/// The pose made of a rigid matrix's axes and place, with unit axes.
glm::dmat4 pose_of(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& backward, const glm::dvec3& eye);

/// What the projection adds to a pose that goes with it: its kind, the lens, and which way is forward and right. False where the two disagree.
bool add_projection(Camera& camera, const glm::dmat4& ndc_from_world, const Window& display, double pixel_aspect);

/// The cameras that the projection alone may mean: image y up or down, the likelier first. Empty where it is no projection with straight axes.
std::vector<Camera> cameras_of_projection(const glm::dmat4& ndc_from_world, const Window& display, double pixel_aspect);

}  // namespace relume
