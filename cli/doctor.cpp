// relume doctor: what is wrong with a G-buffer, where, what it does to the picture, and which option mends it; exit 1 on a defect.
#include "gbuffer/doctor.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/reading_arguments.h"
#include "gbuffer/contact_sheet.h"
#include "gbuffer/convention.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/camera_choice.h"
#include "host/rig.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

struct DoctorArguments {
  std::string file, png;
  std::vector<std::string> rigs;
  bool json = false, overwrite = false;
  ReadingArguments reading;
};

/// The rigs, taken to the file's world as relume shade takes them.
std::vector<Rig> rigs_of(const ExrFile& file, const ReadingOptions& reading, const std::vector<std::string>& files) {
  if (files.empty()) return {};
  std::vector<Rig> rigs = read_rigs({files.begin(), files.end()}, {}, convention_of(file, reading).name);
  try {
    understand_with_rigs(file, reading, rigs);
  } catch (const Error&) {  // diagnose() meets the same and tells it as a finding
  }
  return rigs;
}

/// Of the lights that stand somewhere: a position counts by its distance to them.
std::vector<glm::dvec3> places_of(const std::vector<Light>& lights) {
  std::vector<glm::dvec3> places;
  for (const Light& light : lights)
    if (light.type == LightType::point || light.type == LightType::spot) places.push_back(light.position);
  return places;
}

Diagnosis diagnosis_with(const ExrFile& file, const ReadingOptions& options, const std::vector<glm::dvec3>& lights, std::vector<Rig> rigs) {
  if (rigs.empty()) return diagnose(file, options, lights);
  return diagnose(file, options, lights, [rigs](const ExrFile& f, const ReadingOptions& o) mutable { return understand_with_rigs(f, o, rigs); });
}

const char* name_of(Severity severity) { return severity == Severity::defect ? "defect" : "hint"; }

Json finding_json(const Finding& f) {
  Json json{{"ailment", f.ailment}, {"severity", name_of(f.severity)}, {"layer", f.layer.empty() ? Json() : Json(f.layer)}};
  if (f.where) {
    json["pixels"] = f.where->pixels;
    json["box"] = {{"x0", f.where->box.min_x}, {"y0", f.where->box.min_y}, {"x1", f.where->box.max_x}, {"y1", f.where->box.max_y}};
    json["example"] = {{"x", f.where->x}, {"y", f.where->y}};
  }
  json["what"] = f.what;
  json["effect"] = f.effect;
  json["cure"] = f.cure;
  return json;
}

Json diagnosis_json(const ExrFile& file, const Diagnosis& diagnosis) {
  Json findings = Json::array();
  for (const Finding& f : diagnosis.findings) findings.push_back(finding_json(f));
  Json json{{"file", file.path().string()},       {"convention", diagnosis.reading.convention},
            {"understood", diagnosis.understood}, {"pixels", diagnosis.reading.data_window.pixels()},
            {"sick", diagnosis.sick()},           {"findings", findings}};
  if (!diagnosis.understood) json["why_not"] = diagnosis.why_not;
  return json;
}

void print(const Finding& f) {
  const auto line = [](const char* head, const std::string& text) { std::printf("%-8s%s\n", head, printable_sentence(text).c_str()); };
  line(name_of(f.severity), f.ailment + (f.layer.empty() ? "" : " in " + printable(f.layer)) + ": " + f.what);
  if (f.where)
    std::printf("        %lld pixels within (%d, %d) .. (%d, %d), such as (%d, %d)\n", static_cast<long long>(f.where->pixels), f.where->box.min_x,
                f.where->box.min_y, f.where->box.max_x - 1, f.where->box.max_y - 1, f.where->x, f.where->y);
  if (!f.effect.empty()) line("", "effect: " + f.effect);
  if (!f.cure.empty()) line("", "cure:   " + f.cure);
}

void print(const ExrFile& file, const Diagnosis& diagnosis) {
  std::size_t defects = 0;
  for (const Finding& f : diagnosis.findings) {
    print(f);
    defects += f.severity == Severity::defect;
  }
  std::printf("%s: %zu defect(s), %zu hint(s)\n", printable(file.path().string()).c_str(), defects, diagnosis.findings.size() - defects);
}

/// A picture of each layer, one of where the findings are, and a sheet of all.
void write_pictures(const ExrFile& file, const Diagnosis& diagnosis, const std::vector<glm::dvec3>& lights, const DoctorArguments& a) {
  const std::filesystem::path folder = a.png;
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) throw Error(ErrorKind::output, printable(a.png) + ": the folder cannot be made (" + fault.message() + ")");
  std::vector<View> views = false_colour_views(file, diagnosis.reading);
  if (views.empty()) throw Error(ErrorKind::input, printable(a.file) + ": no layer to make a picture of");
  std::vector<bool> defect(256);
  for (std::size_t k = 0; k < std::min<std::size_t>(diagnosis.findings.size(), 255); ++k)
    defect[k + 1] = diagnosis.findings[k].severity == Severity::defect;
  const auto normals = std::find_if(views.begin(), views.end(), [](const View& v) { return v.name == "normal"; });
  const View& under = normals == views.end() ? views.front() : *normals;
  views.push_back(marked_view(under, diagnosis.reading.data_window, mark_findings(file, diagnosis, lights), defect));
  for (const View& view : views) write_png(folder / (view.name + ".png"), view.picture, a.overwrite);
  write_png(folder / "sheet.png", contact_sheet(views), a.overwrite);
}

int doctor(const DoctorArguments& a) {
  const ExrFile file(a.file);
  const ReadingOptions options = a.reading.options();
  const std::vector<Rig> rigs = rigs_of(file, options, a.rigs);
  const std::vector<glm::dvec3> lights = places_of(merge(rigs).lights);
  const Diagnosis diagnosis = diagnosis_with(file, options, lights, rigs);
  if (a.json)
    std::cout << diagnosis_json(file, diagnosis).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  else
    print(file, diagnosis);
  const auto damaged = [](const Finding& f) { return f.ailment == "incomplete"; };
  if (!a.png.empty() && std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(), damaged))
    std::cerr << "relume: no pictures of a file whose rows cannot all be decoded\n";
  else if (!a.png.empty())
    write_pictures(file, diagnosis, lights, a);
  return diagnosis.sick() ? 1 : 0;
}

}  // namespace

void add_doctor(CLI::App& command, Action& action) {
  const auto a = std::make_shared<DoctorArguments>();
  command.add_option("gbuffer", a->file, "an OpenEXR file")->required();
  command.add_option("-l,--lights", a->rigs, "rigs whose lights the precision of positions is judged by");
  command.add_option("--png", a->png, "a folder for a picture of each layer in false colours, and a sheet of all");
  command.add_flag("--overwrite", a->overwrite, "replace pictures that are there");
  command.add_flag("--json", a->json, "for programs");
  a->reading.add_to(command);
  command.footer("Example: relume doctor shot.exr --lights rig.json");
  command.callback([a, &action] { action = [a] { return doctor(*a); }; });
}

}  // namespace relume
