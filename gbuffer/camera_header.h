// The camera that a header states: worldToCamera, worldToNDC and their kin, in the ways that renderers really store them (research: exr-conventions
// B).
#pragma once

#include <ImfHeader.h>

#include <vector>

#include "gbuffer/camera.h"

namespace relume {

/// Every camera that the header's matrices may mean, the likeliest first: OpenEXR's row vectors or pbrt's transposed storage.
/// Which one is right, the positions tell (fit_pose). Empty where there is no matrix of the kind. Perspective or not, and the field of
/// view, come from worldToNDC or worldToScreen, else from fieldOfViewVertical.
std::vector<Camera> header_cameras(const Imf::Header& header, const Window& display);

}  // namespace relume
