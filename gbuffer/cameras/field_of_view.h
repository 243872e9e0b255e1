// Lenses from what headers call a field of view, a focal length with its film, or a screen window.
#pragma once

#include <optional>

#include "gbuffer/camera.h"
#include "gbuffer/cameras/header_values.h"

namespace relume {

/// The lens of a centred window that is `width` units wide one unit in front of the eye: 2 tan(half the horizontal field of view).
std::optional<Lens> lens_of_width(double width, const Window& display, double pixel_aspect);

/// The same from degrees; empty unless within 0..180.
std::optional<Lens> lens_of_degrees(double horizontal, const Window& display, double pixel_aspect);

/// By the first attribute that tells: fieldOfView*, CameraFov, focal length and film in the names of renderers and of OpenEXR, the screen window.
std::optional<Lens> stated_lens(const HeaderValues& values, const Window& display);

/// A perspective camera with its lens and field of view.
void set_lens(Camera& camera, const std::optional<Lens>& lens, const Window& display);

}  // namespace relume
