// A diagnosis: the reading as far as it goes, then the examination.
#include "gbuffer/doctor.h"

#include <algorithm>
#include <array>
#include <set>

#include "gbuffer/ailments/examination.h"
#include "gbuffer/error.h"
#include "gbuffer/role_layers.h"

namespace relume {

bool Diagnosis::sick() const {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::defect; });
}

namespace {

bool options_name_layers(const ReadingOptions& options) {
  return !options.map.empty() || options.part || !options.view.empty() || !options.view_layer.empty() || !options.convention.empty();
}

/// Every layer that has no role, under its own name: what can still be looked at in a file that is no G-buffer.
void add_remaining_layers(const std::vector<Layer>& layers, Reading& reading) {
  std::set<std::string> taken;
  for (const auto& [role, layer] : reading.roles) taken.insert(layer.channels.begin(), layer.channels.end());
  for (const Layer& layer : layers) {
    RoleLayer all{layer.part, display_name(layer, true), {}, {}};
    std::vector<Component> components = layer.components;
    const auto rank = [order = layer.triple()](const Component& c) { return std::find(order.begin(), order.end(), c.channel) - order.begin(); };
    std::stable_sort(components.begin(), components.end(), [&](const Component& a, const Component& b) { return rank(a) < rank(b); });
    for (const Component& component : components) {
      if (taken.contains(component.channel)) continue;
      all.channels.push_back(component.channel);
      all.types.push_back(component.type);
    }
    if (!all.channels.empty()) reading.roles["layer " + std::to_string(layer.part) + ' ' + all.layer] = all;
  }
}

/// What the names tell, of the first part that has any channels.
Reading reading_by_names(const ExrFile& file) {
  Reading reading;
  const Convention& convention = convention_of(file, {});
  auto layers = layers_of(file);
  if (layers.empty()) return reading;
  reading.part = layers.front().part;
  std::erase_if(layers, [&](const Layer& layer) {
    const auto &first = file.parts()[std::size_t(reading.part)], &own = file.parts()[std::size_t(layer.part)];
    return !(own.data_window == first.data_window) || layer.view != layers.front().view || layer.view_layer != layers.front().view_layer;
  });
  reading.convention = convention.name;
  reading.evidence = evidence_for(convention, file, layers_of(file)).words;
  assign_roles(convention, file, layers, reading);
  add_remaining_layers(layers, reading);
  reading.data_window = file.parts()[std::size_t(reading.part)].data_window;
  reading.display_window = file.parts()[std::size_t(reading.part)].display_window;
  return reading;
}

}  // namespace

Diagnosis diagnose(const ExrFile& file, const ReadingOptions& options, const std::vector<glm::dvec3>& lights, const Understanding& understand) {
  Diagnosis diagnosis;
  try {
    diagnosis.reading = understand(file, options);
  } catch (const Error& error) {
    if (error.kind != ErrorKind::input || options_name_layers(options)) throw;
    diagnosis.understood = false;
    diagnosis.why_not = error.what();
    diagnosis.reading = reading_by_names(file);
  }
  const Patient patient{file, diagnosis.reading, diagnosis.understood, lights};
  Examination examination(patient);
  examination.look();
  diagnosis.findings = examination.conclude();
  const auto unreadable = [](const Finding& f) { return f.ailment == "incomplete"; };
  if (!diagnosis.understood && std::none_of(diagnosis.findings.begin(), diagnosis.findings.end(), unreadable))
    diagnosis.findings.push_back({"not_understood", Severity::defect, "", {}, diagnosis.why_not, "relume shade refuses the file", ""});
  std::stable_sort(diagnosis.findings.begin(), diagnosis.findings.end(), [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return diagnosis;
}

std::vector<std::uint8_t> mark_findings(const ExrFile& file, const Diagnosis& diagnosis, const std::vector<glm::dvec3>& lights) {
  std::vector<std::uint8_t> marks(std::size_t(diagnosis.reading.data_window.pixels()));
  const Patient patient{file, diagnosis.reading, diagnosis.understood, lights};
  Examination examination(patient);
  std::array<std::uint8_t, 256> finding_of{};
  bool any = false;
  for (std::size_t k = 0; k < std::min<std::size_t>(diagnosis.findings.size(), 254); ++k) {
    const auto& where = diagnosis.findings[k].where;
    if (!where || where->mark == 0) continue;
    finding_of[where->mark] = std::uint8_t(k + 1);
    examination.mark_in(marks.data(), where->mark);
    any = true;
  }
  if (!any) return marks;  // a large frame takes seconds
  examination.look();
  for (std::uint8_t& mark : marks) mark = finding_of[mark];
  return marks;
}

}  // namespace relume
