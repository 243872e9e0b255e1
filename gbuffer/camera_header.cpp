// Gathers what each way of stating a camera finds in a header.
#include "gbuffer/camera_header.h"

#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/list.h"

namespace relume {

#define RELUME_DECLARE(name) extern const HeaderCamera header_camera_##name;
RELUME_HEADER_CAMERAS(RELUME_DECLARE)
#undef RELUME_DECLARE

const std::vector<HeaderCamera>& header_camera_list() {
#define RELUME_ENTRY(name) header_camera_##name,
  static const std::vector<HeaderCamera> list{RELUME_HEADER_CAMERAS(RELUME_ENTRY)};
#undef RELUME_ENTRY
  return list;
}

std::vector<Camera> header_cameras(const Imf::Header& header, const Window& display) {
  const HeaderValues values(header);
  std::vector<Camera> cameras;
  for (const HeaderCamera& way : header_camera_list())
    for (Camera& camera : way.read(values, display)) cameras.push_back(std::move(camera));
  return cameras;
}

std::vector<Camera> header_cameras(const ExrFile& file, int part, const Window& display) {
  const Part& own = file.parts()[std::size_t(part)];
  std::vector<Camera> cameras = header_cameras(own.header, display);
  for (const Part& other : file.parts()) {
    if (!cameras.empty()) break;
    if (other.view == own.view || other.view.empty() || own.view.empty()) cameras = header_cameras(other.header, display);
  }
  return cameras;
}

}  // namespace relume
