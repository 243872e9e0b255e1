// Lenses from fields of view (research: exr-conventions B.1, B.3; screen window: openexr.com, "Technical Introduction").
#include "gbuffer/cameras/field_of_view.h"

#include <cmath>
#include <numbers>

namespace relume {
namespace {

double width_of_degrees(double degrees) { return degrees > 0 && degrees < 180 ? 2 * std::tan(degrees * std::numbers::pi / 360) : 0; }

/// Focal length and the film's width, in the same unit.
std::optional<Lens> lens_of_film(double focal, double film, const Window& display, double pixel_aspect) {
  return focal > 0 && film > 0 ? lens_of_width(film / focal, display, pixel_aspect) : std::nullopt;
}

/// Both angles: pixels need not be as the header's aspect says.
std::optional<Lens> lens_of_angles(const HeaderValues& values, const Window& display) {
  const double across = width_of_degrees(values.number("fieldOfViewHorizontal").value_or(0)),
               down = width_of_degrees(values.number("fieldOfViewVertical").value_or(0));
  if (across <= 0 && down <= 0) return {};
  if (across <= 0) return lens_of_width(down / display.height() * display.width() * values.pixel_aspect(), display, values.pixel_aspect());
  std::optional<Lens> lens = lens_of_width(across, display, values.pixel_aspect());
  if (lens && down > 0) lens->scale_y = display.height() / down;
  return lens;
}

/// "The screen window": width and centre of the display window on the plane one unit in front of the eye. 1 and (0, 0) are what libraries fill in.
std::optional<Lens> lens_of_screen_window(const HeaderValues& values, const Window& display) {
  const Imf::Header& header = values.header();
  const double width = header.screenWindowWidth(), x = header.screenWindowCenter().x, y = header.screenWindowCenter().y;
  if ((width == 1 && x == 0 && y == 0) || !(width > 0) || !std::isfinite(width + x + y)) return {};
  std::optional<Lens> lens = lens_of_width(width, display, values.pixel_aspect());
  if (lens) lens->centre_x -= x * lens->scale_x, lens->centre_y += y * lens->scale_y;
  return lens;
}

}  // namespace

std::optional<Lens> lens_of_width(double width, const Window& display, double pixel_aspect) {
  const double scale_x = display.width() / width, scale_y = scale_x * pixel_aspect;
  if (!(width > 0) || !std::isfinite(scale_x) || !(scale_x > 0)) return {};
  return Lens{scale_x, scale_y, 0.5 * (display.min_x + display.max_x), 0.5 * (display.min_y + display.max_y)};
}

std::optional<Lens> lens_of_degrees(double horizontal, const Window& display, double pixel_aspect) {
  return lens_of_width(width_of_degrees(horizontal), display, pixel_aspect);
}

std::optional<Lens> stated_lens(const HeaderValues& values, const Window& display) {
  const double aspect = values.pixel_aspect();
  const auto number = [&](const char* name) { return values.number(name).value_or(0); };
  if (const auto lens = lens_of_angles(values, display)) return lens;
  if (const auto lens = lens_of_degrees(number("CameraFov"), display, aspect)) return lens;  // Arnold and V-Ray: horizontal
  for (const char* film : {"CameraFilmApertureHorizontal", "cameraAperture"})
    if (const auto lens = lens_of_film(number("CameraFocalLength"), number(film), display, aspect)) return lens;
  if (const auto lens = lens_of_film(number("focal"), number("haperture"), display, aspect)) return lens;  // RenderMan's exrheader_*
  const auto sensor = values.numbers("sensorOverallDimensions", 2);
  for (const char* focal : {"effectiveFocalLength", "pinholeFocalLength", "nominalFocalLength"})
    if (const auto lens = lens_of_film(number(focal), sensor ? sensor->front() : 0, display, aspect)) return lens;
  return lens_of_screen_window(values, display);
}

void set_lens(Camera& camera, const std::optional<Lens>& lens, const Window& display) {
  camera.lens = lens;
  if (lens) set_extent(camera, *lens, display);
}

}  // namespace relume
