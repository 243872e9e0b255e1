// Rig files: which kind a file is, and several rigs as one.
#include "host/rig.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "gbuffer/error.h"
#include "host/json.h"
#include "host/rig_alignment.h"
#include "host/rig_readers.h"

namespace relume {
namespace {

bool is_glb(std::string_view content) { return content.starts_with("glTF"); }

/// Little-endian, as all of GLB.
std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
  return word;
}

/// The JSON chunk of a GLB (glTF 2.0, section 4.4): a header of 12 bytes, then chunks of length, type and data, the JSON first.
std::string_view json_chunk(std::string_view content, const std::string& file) {
  const auto fail = [&](const std::string& what) { throw Error(ErrorKind::input, file + ": " + what); };
  if (content.size() < 20) fail("GLB: cut short in its header");
  if (word_at(content, 4) != 2) fail("GLB: version " + std::to_string(word_at(content, 4)) + " (2 is known)");
  const std::size_t length = word_at(content, 12);
  if (content.substr(16, 4) != "JSON") fail("GLB: its first chunk is not JSON");
  if (length > content.size() - 20) fail("GLB: cut short in its JSON chunk");
  return content.substr(20, length);
}

/// Per-light layers are told apart by name: a name that is taken gets the next free "_2", "_3", ...
void make_names_unique(std::vector<Light>& lights) {
  std::set<std::string> taken;
  for (Light& light : lights) {
    std::string name = light.name;
    for (int i = 2; !taken.insert(name).second; ++i) name = light.name + "_" + std::to_string(i);
    light.name = name;
  }
}

}  // namespace

glm::dvec3 unit_or_zero(const glm::dvec3& direction) {
  const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (largest == 0) return glm::dvec3(0);
  return glm::normalize(direction / largest);  // squares of 1e-200 would vanish
}

std::string beyond_single(const Light& light) {
  const auto fits = [](double x) { return std::abs(x) <= std::numeric_limits<float>::max(); };  // false for NaN and infinity too
  const auto fits3 = [&](const glm::dvec3& v) { return fits(v.x) && fits(v.y) && fits(v.z); };
  if (!fits3(light.position)) return "position";
  if (!fits3(light.direction)) return "direction";
  if (!fits3(light.intensity)) return "intensity";
  if (light.fraction && !fits(*light.fraction)) return "fraction";
  if (!fits(light.range)) return "range";
  return "";
}

Rig read_rig(const std::filesystem::path& file, const RigOptions& options) {
  const std::string name = shown(file), content = read_text(file);
  const std::string_view text = is_glb(content) ? json_chunk(content, name) : content;
  const Json json = parse_json(text, name);
  const bool is_gltf = is_glb(content) || json.find("asset") != nullptr;
  Rig rig = is_gltf ? read_gltf_rig(json, text, name, options) : read_json_rig(json, name);
  make_names_unique(rig.lights);
  if (options.scale) transform(rig, {glm::dmat3(1.0), *options.scale, 0, 0});
  return rig;
}

std::vector<Rig> read_rigs(const std::vector<std::filesystem::path>& files, RigOptions options, const std::string& convention) {
  options.convention = convention;
  options.world_is_z_up = convention == "blender";
  std::vector<Rig> rigs;
  for (const auto& file : files) rigs.push_back(read_rig(file, options));
  return rigs;
}

Rig merge(std::vector<Rig> rigs) {
  Rig all;
  for (Rig& rig : rigs) {
    std::move(rig.lights.begin(), rig.lights.end(), std::back_inserter(all.lights));
    std::move(rig.notes.begin(), rig.notes.end(), std::back_inserter(all.notes));
    if (!all.camera) all.camera = std::move(rig.camera);
  }
  make_names_unique(all.lights);
  return all;
}

}  // namespace relume
