// understand_with_rigs: the rigs' cameras checked against the file, and their worlds against its.
#include "host/camera_choice.h"

#include <algorithm>
#include <sstream>

#include "gbuffer/camera_header.h"
#include "gbuffer/error.h"
#include "host/json.h"
#include "host/rig_alignment.h"

namespace relume {
namespace {

std::string text(const glm::dvec3& p) {
  std::ostringstream out;
  out << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return out.str();
}

std::string rounded(double number) {
  std::ostringstream out;
  out.precision(2);
  out << number;
  return out.str();
}

/// World positions say whether the camera stands where they were seen from; others tell its lens at most.
bool pose_is_checked(const Reading& reading) {
  return reading.camera && reading.camera->residual >= 0 && reading.roles.contains("position") && reading.position_space == Space::world;
}

bool is_open(const Rig& rig) { return rig.axes_open || rig.scale_open; }

/// What the header may mean can be ambiguous (V-Ray's axes): the reading that a rig's camera goes with is the one.
Reading reading_by_header(const ExrFile& file, ReadingOptions options, const Rig& rig, const std::vector<Camera>& stated) {
  const auto same = [&](const Camera& camera) { return align(*rig.camera, camera, {rig.axes_open, rig.scale_open}).has_value(); };
  const auto found = std::find_if(stated.begin(), stated.end(), same);
  if (found != stated.end()) options.camera = *found;
  return understand(file, options);
}

/// The file with the camera that it tells itself, where it tells one and the rig's will not do.
std::optional<Reading> own_reading(const ExrFile& file, const ReadingOptions& options, const Rig& rig, const Reading& with_rig) {
  if (pose_is_checked(with_rig)) {
    if (!with_rig.camera->contradicted()) return {};
    Reading own = understand(file, options);
    const bool better = own.camera && own.camera->residual >= 0 && own.camera->residual < with_rig.camera->residual;
    return better ? std::optional(std::move(own)) : std::nullopt;
  }
  const auto stated = header_cameras(file, with_rig.part, with_rig.display_window);
  if (stated.empty() || !is_open(rig)) return {};
  Reading own = reading_by_header(file, options, rig, stated);
  return own.camera ? std::optional(std::move(own)) : std::nullopt;
}

/// "its camera is then the file's to 0.01 degrees and 0.02 % of the distance"
std::string how_well(const Alignment& a) {
  return "its camera is then the file's to " + rounded(a.angle) + " degrees and " + rounded(100 * a.off) + " % of the distance";
}

void settle_gltf(Rig& rig, const Reading& reading) {
  const std::string name = rig.camera->source;
  const auto found = align(*rig.camera, *reading.camera, {rig.axes_open, rig.scale_open});
  if (!found)
    rig.notes.push_back("warning: " + name + ": no exchange of axes and no scale makes its camera the one that saw the file" +
                        (rig.assumed_axes.empty() ? "" : "; " + rig.assumed_axes));
  if (!found || found->is_identity()) return;
  transform(rig, *found);
  rig.notes.push_back(name + ": taken to the G-buffer's world, " + described(*found) + ": " + how_well(*found) +
                      (found->scale == 1 ? "" : "; intensities of points and spots are multiplied by " + in_digits(found->scale * found->scale)) +
                      " (--rig-up and --rig-scale overrule)");
}

/// A JSON rig is in the G-buffer's world by definition: it is told, not turned.
void warn_of_json(Rig& rig, const Reading& reading) {
  const auto found = align(*rig.camera, *reading.camera);
  if (!found || found->is_identity()) return;
  rig.notes.push_back("warning: " + rig.camera->source + ": its camera would be the file's if " + described(*found) +
                      "; a JSON rig is taken as it is, in the G-buffer's world" + (found->scale == 1 ? "" : " (--rig-scale scales it)"));
}

void settle(Rig& rig, const Reading& reading) {
  if (!rig.camera && !rig.assumed_axes.empty()) rig.notes.push_back(rig.assumed_axes + " (it has no camera to tell by)");
  if (rig.camera) is_open(rig) ? settle_gltf(rig, reading) : warn_of_json(rig, reading);
}

/// A rig may well be of another shot, or know one eye of two.
void say_which(const Camera& rig, Reading& reading) {
  const auto left = align(rig, *reading.camera, {false, false});
  if (left && left->angle < 0.2 && left->off < 2e-3) return;  // what recovering a camera leaves
  const Camera& own = *reading.camera;
  reading.notes.push_back("the rig's camera at " + text(rig.eye()) + " is not the one that saw this file, which stands at " + text(own.eye()) + " (" +
                          own.source + "); the file's is used (--camera RIG overrules)");
}

}  // namespace

Reading understand_with_rigs(const ExrFile& file, const ReadingOptions& options, std::vector<Rig>& rigs) {
  const auto rig = std::find_if(rigs.begin(), rigs.end(), [](const Rig& r) { return r.camera.has_value(); });
  ReadingOptions with_rig = options;
  const bool rig_is_asked = rig != rigs.end() && !options.camera && !options.recover_camera;
  if (rig_is_asked) with_rig.camera = rig->camera;
  Reading reading = understand(file, with_rig);
  const auto own = rig_is_asked ? own_reading(file, options, *rig, reading) : std::nullopt;
  if (own) reading = *own;
  if (!reading.camera)
    throw Error(ErrorKind::input,
                file.path().string() +
                    ": no camera: none in the header or the rig, and the positions do not determine one (--camera FILE names a rig, a glTF "
                    "or another EXR)");
  for (Rig& each : rigs) settle(each, reading);
  if (own) say_which(*rig->camera, reading);
  return reading;
}

}  // namespace relume
