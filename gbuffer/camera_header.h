// The cameras that a header states, in the ways that renderers really store them (research: exr-conventions B).
#pragma once

#include <ImfHeader.h>

#include <optional>
#include <vector>

#include "gbuffer/camera.h"
#include "gbuffer/exr_file.h"

namespace relume {

class HeaderValues;

/// One way of stating a camera: a file in gbuffer/cameras/ and a line in its list.
struct HeaderCamera {
  const char* name;    ///< "vray"
  const char* title;   ///< the attributes: "cameraTransform and cameraFov"
  const char* source;  ///< where its facts come from
  /// What the attributes may mean, the likeliest first; empty where there are none of the kind.
  std::vector<Camera> (*read)(const HeaderValues& values, const Window& display);
};

const std::vector<HeaderCamera>& header_camera_list();

/// Every camera that the header may mean, the likeliest first, with its lens where the header tells one. Which one is right, the positions tell
/// (fit_pose).
std::vector<Camera> header_cameras(const Imf::Header& header, const Window& display);

/// Those of the part, else of another part of the same view or of none: many writers describe the camera in the first part only.
std::vector<Camera> header_cameras(const ExrFile& file, int part, const Window& display);

/// The lens alone, of a header that tells a field of view but no place.
std::optional<Lens> header_lens(const ExrFile& file, int part, const Window& display);

}  // namespace relume
