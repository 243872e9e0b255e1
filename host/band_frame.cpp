// band_frame: planes' numbers and the viewer.
#include "host/band_frame.h"

namespace relume {

Frame band_frame(const GBuffer& gbuffer, const Reading& reading, const Planes& out) {
  Frame frame{};
  frame.pixels = int(gbuffer.samples());
  frame.plane_stride = int(gbuffer.planes.stride());
  frame.position = gbuffer.position.first;
  frame.normal = gbuffer.normal.first;
  frame.base_normal = gbuffer.base_normal.count ? gbuffer.base_normal.first : -1;
  frame.bump_shadowing = gbuffer.base_normal.count ? int(reading.bump_shadowing) : int(BUMP_none);
  const Camera& camera = *reading.camera;
  const bool orthographic = camera.projection == Camera::Projection::orthographic;
  const glm::dvec3 viewer = orthographic ? camera.backward() : camera.eye();
  for (int c = 0; c < 3; ++c) frame.viewer[c] = float(viewer[c]);
  frame.viewer[3] = orthographic ? 0.0f : 1.0f;
  frame.out_stride = int(out.stride());
  frame.diffuse = frame.specular = frame.ambient_out = -1;
  return frame;
}

}  // namespace relume
