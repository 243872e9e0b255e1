// Names taken apart into words; what is left without words of space and kind is looked up (names: research exr-conventions 0.3, and the corpus).
#include "gbuffer/common_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "gbuffer/printable.h"

namespace relume {
namespace {

using Words = std::vector<std::string>;
using WordSet = std::set<std::string, std::less<>>;

const WordSet world_words{"world", "ws", "wld", "global", "w"};
const WordSet camera_words{"camera", "cam", "cs", "view", "vs", "eye"};
const WordSet shading_words{"shading", "sh", "bump", "bumped", "smooth", "interpolated"};
const WordSet geometric_words{"geo", "geom", "geometry", "geometric", "face", "facet", "flat", "true"};
const WordSet unsigned_words{"encoded", "packed", "unsigned", "unorm"};
const WordSet doubtful_words{"denoising", "denoise", "denoised", "optix", "oidn", "filtered"};
/// Words that change nothing.
const WordSet plain_words{"space",   "pass",    "aov",  "layer",  "image",  "buffer", "gbuffer", "map", "vector",  "element", "util",
                          "tech",    "rs",      "ai",   "out",    "output", "first",  "primary", "hit", "surface", "pixel",   "final",
                          "visible", "channel", "data", "signed", "float",  "vray",   "the",     "mtl", "material"};
const WordSet normal_words{"normal", "normals", "n", "nrm", "nrml", "nn", "norm", "ns", "sn", "shn"};

/// What the words without those of space and kind spell, the plainest first.
struct Spelling {
  const char* role;
  std::vector<const char*> words;
  Says says = Says::nothing;
};
const std::vector<Spelling>& spellings() {
  static const std::vector<Spelling> all{
      {"position", {"position", "p", "pos", "point", "pointposition", "positions", "points", "coordinate", "coordinates", "coords", "location"}},
      {"position", {"wpos", "pw", "wp"}, Says::world},
      {"base_normal", {"ng", "gn"}},
      {"depth", {"z", "depth", "zdepth", "depthz", "pz", "scenedepth", "lineardepth", "zbuffer", "zbuf"}},
      {"depth", {"distance", "hitdist", "hitdistance", "raylength", "raydistance", "depthdistance", "radialdepth"}, Says::distance},
      {"albedo",
       {"albedo", "basecolor", "basecolour", "diffusealbedo", "diffusecolor", "diffusecolour", "diffcol", "diffusefilter", "diffusecol", "basecol",
        "albedodiffuse", "rawdiffusefilter", "cd", "unlit", "albedoraw", "rawalbedo", "base"}},
      {"roughness",
       {"roughness", "rough", "specularroughness", "specroughness", "reflectionroughness", "reflectroughness", "baseroughness", "glossyroughness",
        "rgh"}},
      {"metallic", {"metallic", "metalness", "metal", "metallicity", "basemetalness"}},
      {"glossiness", {"glossiness", "gloss", "smoothness", "reflectionglossiness", "reflectglossiness", "specularglossiness"}},
      {"exponent", {"exponent", "shininess", "specularexponent", "phongexponent", "specularpower"}},
      {"alpha", {"ggxalpha", "alphaggx", "roughnessalpha", "alpharoughness", "microfacetalpha"}},
      {"f0", {"f0", "specularf0", "reflectancef0"}},
      {"specular_level", {"specularlevel", "speclevel"}},
      {"ior", {"ior", "refractiveindex", "refractionindex", "indexofrefraction", "reflectior", "reflectionior"}},
      {"coverage", {"", "rgba", "beauty", "combined", "alpha", "coverage", "a"}},
      {"ids", {"id", "ids", "objectid", "objectindex", "indexob", "shapeindex", "objid", "element", "elementid", "instanceid", "renderid"}},
      {"uv", {"uv", "st", "uvs", "texcoord", "texcoords", "texturecoordinate", "texturecoordinates"}},
      {"diffuse_light", {"diffuselighting", "diffuselight", "lighting", "difflight"}},
      {"diffuse_raw_light",
       {"diffuselightingraw", "rawdiffuselighting", "diffuserawlighting", "diffuselightraw", "rawdiffuselight", "rawlighting", "lightingraw",
        "rawlight", "lightraw"}}};
  return all;
}

/// "WorldNormals", "zDepth", "P_ws": words begin at capitals and end at whatever is no letter or digit.
Words words_of(std::string_view name) {
  Words words{""};
  const auto upper = [&](std::size_t i) { return i < name.size() && std::isupper(static_cast<unsigned char>(name[i])); };
  const auto small = [&](std::size_t i) { return i < name.size() && std::islower(static_cast<unsigned char>(name[i])); };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool begins = upper(i) && i > 0 && (small(i - 1) || (upper(i - 1) && small(i + 1)));
    if ((begins || !std::isalnum(c)) && !words.back().empty()) words.emplace_back();
    if (std::isalnum(c)) words.back() += char(std::tolower(c));
  }
  if (words.back().empty()) words.pop_back();
  for (std::size_t i = 0; i + 1 < words.size(); ++i)  // a view layer is no view space
    if ((words[i] == "view" || words[i] == "render") && words[i + 1] == "layer") words.erase(words.begin() + std::ptrdiff_t(i));
  return words;
}

/// "nworld", "positionws": a word of space written together with another.
void split_space(Words& words) {
  static constexpr std::array<std::string_view, 6> spaces{"world", "camera", "cam", "view", "eye", "ws"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    if (plain_words.contains(word) || camera_words.contains(word)) continue;
    for (const std::string_view space : spaces) {
      if (word.size() <= space.size()) continue;
      const bool before = word.starts_with(space), after = word.ends_with(space);
      if (!before && !after) continue;
      words[i] = before ? word.substr(space.size()) : word.substr(0, word.size() - space.size());
      words.emplace_back(space);
      break;
    }
  }
}

bool take(Words& words, const WordSet& known) {
  return std::erase_if(words, [&](const std::string& word) { return known.contains(word); }) > 0;
}

std::string together(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

/// Normals have many kinds: the shading normal is wanted, the geometric one is a role of its own.
std::optional<NameMeaning> normal_meaning(Words words) {
  const bool geometric = take(words, geometric_words), shading = take(words, shading_words), encoded = take(words, unsigned_words);
  if (words.size() != 1 || !normal_words.contains(words.front())) return {};
  const bool plain = words.front() == "normal" || words.front() == "normals";
  return NameMeaning{geometric && !shading ? "base_normal" : "normal", Says::nothing, encoded, (shading ? 0 : 2) + (plain ? 0 : 1)};
}

std::optional<NameMeaning> spelled(const std::string& text) {
  for (const Spelling& spelling : spellings())
    for (std::size_t i = 0; i < spelling.words.size(); ++i)
      if (text == spelling.words[i]) return NameMeaning{spelling.role, spelling.says, false, int(i) + (spelling.says == Says::distance ? 20 : 0)};
  return {};
}

std::optional<NameMeaning> meaning_of_words(Words words) {
  constexpr int unsaid = 50, seen = 100, unlikely = 200;  // world space first, what denoisers are fed last; spellings number fewer than 50
  if (auto meaning = spelled(together(words)); meaning && (meaning->role == "coverage" || meaning->role == "uv" || meaning->role == "ids"))
    return meaning;
  split_space(words);
  const bool doubtful = take(words, doubtful_words), world = take(words, world_words), camera = take(words, camera_words);
  auto meaning = normal_meaning(words);
  if (!meaning) meaning = spelled(together(words));
  if (!meaning && take(words, plain_words)) {
    meaning = normal_meaning(words);
    if (!meaning && !words.empty()) meaning = spelled(together(words));
  }
  if (!meaning) return {};
  const bool vector = meaning->role == "normal" || meaning->role == "base_normal" || meaning->role == "position";
  if (vector && world != camera) meaning->says = world ? Says::world : Says::camera;
  if (vector) meaning->doubt += world ? 0 : camera ? seen : unsaid;
  meaning->doubt += doubtful ? unlikely : 0;
  return meaning;
}

}  // namespace

std::optional<NameMeaning> meaning_of(const std::string& layer_name) {
  if (const auto whole = meaning_of_words(words_of(layer_name))) return whole;
  const std::size_t dot = layer_name.rfind('.');
  if (dot == std::string::npos) return {};
  auto last = meaning_of_words(words_of(std::string_view(layer_name).substr(dot + 1)));  // "ViewLayer.Normal", "RGBA.beauty"
  if (last) last->doubt += 25;
  return last;
}

namespace {

struct Choice {
  NameMeaning meaning;
  RoleLayer layer;
};

/// For every role the layer whose name speaks of it most plainly; the first of equals.
std::map<std::string, Choice> plainest(const std::vector<NamedLayer>& layers) {
  std::map<std::string, Choice> choices;
  for (const NamedLayer& layer : layers) {
    const auto meaning = meaning_of(layer.name);
    if (!meaning) continue;
    const auto known = choices.find(meaning->role);
    if (known != choices.end() && known->second.meaning.doubt <= meaning->doubt) continue;
    if (RoleLayer candidate = as_role(*layer.layer, meaning->role); !candidate.channels.empty())
      choices[meaning->role] = {*meaning, std::move(candidate)};
  }
  return choices;
}

void remember_names(Reading& reading) {
  constexpr std::size_t enough = 4;  // a line is read by a person
  const auto remember = [&](const char* role, const char* name) {
    std::string& tried = reading.looked_for[role];
    if (*name) tried += (tried.empty() ? "" : ", ") + std::string(name);
  };
  for (const Spelling& spelling : spellings())
    for (std::size_t i = 0; i < std::min(spelling.words.size(), enough); ++i) remember(spelling.role, spelling.words[i]);
  remember("normal", "normal, N, nrm and their like, alone or with world, camera or shading");
}

}  // namespace

void assign_common_names(Reading& reading, const std::vector<NamedLayer>& layers) {
  auto choices = plainest(layers);
  // A geometric normal is the best there is where no other is stored.
  if (!choices.contains("normal") && choices.contains("base_normal")) choices["normal"] = choices["base_normal"];
  for (auto& [role, choice] : choices) {
    if (reading.roles.contains(role)) continue;
    reading.roles[role] = std::move(choice.layer);
    apply(choice.meaning.says, role, reading);
    if (role == "normal" && choice.meaning.unsigned_normals) reading.normal_encoding = NormalEncoding::as_unsigned;
  }
  remember_names(reading);
}

namespace {

/// Of a specular workflow, where no layer tells metal: diffuse colour and reflectance instead of base colour and metalness.
void take_specular_colour(const std::vector<Layer>& layers, Reading& reading) {
  const auto has = [&](const char* role) { return reading.roles.contains(role); };
  if (has("f0") || has("metallic") || !(has("roughness") || has("glossiness") || has("exponent") || has("alpha"))) return;
  assign(reading, named_layers(layers, [](const Layer& layer) { return layer.name; }),
         {"f0", {"specular_color", "specular_colour", "specular_albedo", "spec_color", "albedo_specular", "reflectance"}});
  if (const auto f0 = reading.roles.find("f0"); f0 != reading.roles.end())
    reading.notes.push_back("warning: layer \"" + printable(f0->second.layer) +
                            "\" is taken for the reflectance at normal incidence, but may be a tint or hold light (--map f0=LAYER or --set f0=R,G,B "
                            "say otherwise)");
}

}  // namespace

void take_diffuse(const ExrFile&, const std::vector<Layer>& layers, Reading& reading) {
  take_specular_colour(layers, reading);
  if (reading.roles.contains("albedo") || reading.roles.contains("diffuse_raw_light")) return;
  assign(reading, named_layers(layers, [](const Layer& layer) { return layer.name; }), {"albedo", {"diffuse"}});
  if (const auto albedo = reading.roles.find("albedo"); albedo != reading.roles.end())
    reading.notes.push_back("warning: layer \"" + printable(albedo->second.layer) +
                            "\" is taken for the albedo, but may hold light (--map albedo=LAYER or --set albedo=R,G,B say otherwise)");
}

}  // namespace relume
