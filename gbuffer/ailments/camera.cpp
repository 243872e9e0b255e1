// No camera, or one that did not see the positions, or one whose crop is lost.
#include <cmath>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/camera_header.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

/// Even a matrix that no camera can be made of was meant as one.
bool header_states_one(const Patient& patient) {
  if (!header_cameras(patient.file, patient.reading.part, patient.reading.display_window).empty()) return true;
  const Imf::Header& header = patient.file.parts()[std::size_t(patient.reading.part)].header;
  return matrix_attribute(header, "worldToCamera") || matrix_attribute(patient.file.parts().front().header, "worldToCamera");
}

Finding none() {
  return {"",
          Severity::defect,
          "",
          {},
          "no camera in the file, and none could be recovered from the positions",
          "highlights and Fresnel need the viewer: relume shade refuses lobes that do",
          "--camera FILE: a rig, a glTF or another EXR"};
}

Finding contradicted(const Camera& camera) {
  return {"",
          Severity::defect,
          "",
          {},
          "the camera (" + camera.source + ") sees the positions " + three_digits(camera.residual) + " pixels off their places",
          "highlights and Fresnel are computed for a viewer elsewhere",
          "--camera auto recovers it from the positions, --camera FILE gives another"};
}

Finding replaced(const Camera& camera) {
  return {"",
          Severity::defect,
          "",
          {},
          "the header's camera did not see these positions: one recovered from them is used (residual " + three_digits(camera.residual) + " pixels)",
          "a tool that believes the header puts highlights in wrong places",
          "--camera FILE, if the recovered one is not right"};
}

/// A crop written as if it were the whole picture: the optical axis is where the centre of the whole would be.
void find_lost_crop(const Patient& patient, const Camera& camera, std::vector<Finding>& findings) {
  const Window &data = patient.reading.data_window, &display = patient.reading.display_window;
  if (!camera.lens || !(data == display) || data.min_x != 0 || data.min_y != 0) return;
  const double right = camera.lens->centre_x - 0.5 * display.width(), down = camera.lens->centre_y - 0.5 * display.height();
  constexpr double shifted = 0.02;  // of the side: recovered axes of flat scenes stray by less
  if (std::abs(right) < shifted * display.width() && std::abs(down) < shifted * display.height()) return;
  findings.push_back({"",
                      Severity::hint,
                      "",
                      {},
                      "the optical axis is " + three_digits(right) + " pixels right and " + three_digits(down) +
                          " below the middle of a data window that begins at 0, 0: a crop whose offset was lost, or a shifted lens",
                      "none on light, which needs positions alone; the picture does not lie where it belongs in the whole frame",
                      ""});
}

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  if (!patient.understood || !patient.has("position")) return;
  const auto& camera = patient.reading.camera;
  if (!camera) return findings.push_back(none());
  if (camera->contradicted())
    findings.push_back(contradicted(*camera));
  else if (camera->recovered && header_states_one(patient))
    findings.push_back(replaced(*camera));
  else if (camera->recovered)
    findings.push_back({"",
                        Severity::hint,
                        "",
                        {},
                        "no camera in the file: it was " + camera->source + ", residual " + three_digits(camera->residual) + " pixels",
                        "none where the residual is small",
                        "--camera FILE gives the true one"});
  find_lost_crop(patient, *camera, findings);
}

}  // namespace

extern const Ailment ailment_camera;
const Ailment ailment_camera{"camera", "a missing or contradicted camera", examine};

}  // namespace relume
