// Gathers what each way of stating a camera finds in a header.
#include "gbuffer/camera_header.h"

#include "gbuffer/cameras/field_of_view.h"
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

namespace {

/// The part itself, then others of the same view or of none.
std::vector<const Part*> parts_about(const ExrFile& file, int part) {
  const Part& own = file.parts()[std::size_t(part)];
  std::vector<const Part*> parts{&own};
  for (const Part& other : file.parts())
    if (&other != &own && (other.view == own.view || other.view.empty() || own.view.empty())) parts.push_back(&other);
  return parts;
}

}  // namespace

std::vector<Camera> header_cameras(const ExrFile& file, int part, const Window& display) {
  for (const Part* const about : parts_about(file, part))
    if (auto cameras = header_cameras(about->header, display); !cameras.empty()) return cameras;
  return {};
}

std::optional<Lens> header_lens(const ExrFile& file, int part, const Window& display) {
  for (const Part* const about : parts_about(file, part))
    if (const auto lens = stated_lens(HeaderValues(about->header), display)) return lens;
  return {};
}

}  // namespace relume
