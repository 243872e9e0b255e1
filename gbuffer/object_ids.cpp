// ObjectIds: the layer found, names to ids, ids to shares of pixels.
#include "gbuffer/object_ids.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "gbuffer/cryptomatte_id.h"
#include "gbuffer/error.h"
#include "gbuffer/near_names.h"
#include "gbuffer/printable.h"
#include "gbuffer/sample_rows.h"

namespace relume {
namespace {

constexpr std::size_t grain = 1 << 14;  // pixels that one task takes: enough to hide the scheduler

std::string in_marks(const std::string& name) { return '"' + printable(name) + '"'; }

/// Digits alone, of 32 bits; nothing of "007" or "1.0", which would be second names of a number.
std::optional<std::uint32_t> number_of(const std::string& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || std::to_string(number) != text) return {};
  return number;
}

/// "0x13851a76"
std::optional<std::uint32_t> hexadecimal(const std::string& text) {
  std::uint32_t number = 0;
  if (text.size() != 10 || !text.starts_with("0x")) return {};
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), number, 16);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string in_hexadecimal(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", id);
  return text;
}

/// Below this every whole number has a sample of its own.
std::uint32_t exact_below(SampleType type) { return type == SampleType::half_float ? 1u << 11 : type == SampleType::float32 ? 1u << 24 : ~0u; }

/// What a look at a float layer's ids finds, where there is a normal.
struct Survey {
  std::int64_t seen = 0, no_id = 0, mixed = 0, coarse = 0;
};

Survey survey_of(const ExrFile& file, const Reading& reading, std::uint32_t exact) {
  Survey survey;
  for (const SampledBand& band : sample_rows(file, reading, {"normal", "ids"}))
    for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
      if (band.has("normal") && band.vector("normal", i) == glm::dvec3(0)) continue;
      const double id = double(band.value("ids", i));
      const bool possible = id >= 0 && id < 4294967296.0;
      ++survey.seen;
      survey.no_id += !possible;
      survey.mixed += possible && id != std::floor(id);
      survey.coarse += possible && id >= exact;
    }
  return survey;
}

/// The Cryptomatte that is most likely of objects: a rig and a material file speak of those.
const Cryptomatte* of_objects(const std::vector<Cryptomatte>& all) {
  for (const char* word : {"object", "asset", ""})
    for (const Cryptomatte& candidate : all)
      if (normalised(candidate.name).find(word) != std::string::npos) return &candidate;
  return nullptr;
}

/// Pixels that a layer lacks are left out of the frame, as those that another role lacks are.
void keep_within(const ExrFile& file, const RoleLayer& layer, Reading& reading) {
  const Window& other = file.parts()[std::size_t(layer.part)].data_window;
  Window& window = reading.data_window;
  window = {std::max(window.min_x, other.min_x), std::max(window.min_y, other.min_y), std::min(window.max_x, other.max_x),
            std::min(window.max_y, other.max_y)};
  if (window.empty())
    throw Error(ErrorKind::input, file.path().string() + ": layer " + in_marks(layer.layer) + " has no pixel in common with the other layers");
}

/// Calls visit(pixel, id, coverage) for every rank that shows an object.
template <class Visit>
void for_ranks(const GBuffer& gbuffer, const std::vector<std::string>& roles, std::size_t pixel, const Visit& visit) {
  for (const std::string& role : roles) {
    const PlaneRange& planes = gbuffer.roles.at(role);
    for (int c = 0; c + 1 < planes.count; c += 2) {
      const auto id = std::bit_cast<std::uint32_t>(gbuffer.planes.plane(planes.first + c)[pixel]);
      const float coverage = gbuffer.planes.plane(planes.first + c + 1)[pixel];
      if (id != 0 && coverage > 0) visit(id, std::min(coverage, 1.0f));  // NaN is no coverage
    }
  }
}

template <class Body>
void for_pixels(const GBuffer& gbuffer, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, gbuffer.planes.pixels(), grain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

}  // namespace

ObjectIds::ObjectIds(const ExrFile& file, Reading& reading, const std::string& name, bool by_names) : file_(&file) {
  const std::vector<Cryptomatte> all = cryptomattes_of(file, reading);
  const std::string& wanted = name.empty() ? reading.ids_cryptomatte : name;
  const auto meant = std::find_if(all.begin(), all.end(), [&](const Cryptomatte& c) { return !wanted.empty() && goes_by(c, wanted); });
  const Cryptomatte* cryptomatte = meant == all.end() ? nullptr : &*meant;
  if (!cryptomatte && !name.empty()) reading.roles["ids"] = find_layer(file, reading, name);
  const bool plain = reading.roles.contains("ids") && !(by_names && name.empty());
  if (!cryptomatte && !plain) cryptomatte = of_objects(all);
  if (cryptomatte)
    take_cryptomatte(*cryptomatte, reading);
  else if (plain)
    take_plain(reading);
  else
    throw Error(ErrorKind::input, file.path().string() + (by_names ? ": no Cryptomatte to find objects in by name" : ": no layer of object ids") +
                                      " (\"ids\" in a material file or rig names one; --map ids=LAYER too)");
}

void ObjectIds::take_cryptomatte(const Cryptomatte& cryptomatte, Reading& reading) {
  name_ = cryptomatte.name;
  if (!cryptomatte.defect.empty())
    throw Error(ErrorKind::input, file_->path().string() + ": Cryptomatte " + in_marks(name_) + ": " + cryptomatte.defect);
  for (const RoleLayer& level : cryptomatte.levels) {
    roles_.push_back(std::string(cryptomatte_role) + level.layer);
    reading.roles[roles_.back()] = level;
    keep_within(*file_, level, reading);
  }
  manifest_ = manifest_of(*file_, cryptomatte);
  for (const std::string& note : manifest_.notes) notes_.push_back("Cryptomatte " + in_marks(name_) + ": " + note);
  cryptomatte_ = cryptomatte;
}

void ObjectIds::take_plain(Reading& reading) {
  const RoleLayer& layer = reading.roles.at("ids");
  name_ = layer.layer;
  type_ = layer.types.front();
  roles_ = {"ids"};
  keep_within(*file_, layer, reading);
  if (type_ != SampleType::uint32) note_coarse_ids(reading);
}

void ObjectIds::note_coarse_ids(const Reading& reading) {
  const Survey survey = survey_of(*file_, reading, exact_below(type_));
  const std::string layer = "id layer " + in_marks(name_), of = " of " + std::to_string(survey.seen) + " pixels looked at ";
  if (survey.seen > 0 && survey.no_id == survey.seen)
    throw Error(ErrorKind::input, file_->path().string() + ": " + layer +
                                      " holds no ids: all are negative, NaN or beyond 32 bits (ids are whole numbers " +
                                      "from 0; --map ids=LAYER names another layer)");
  if (survey.no_id > 0)
    notes_.push_back(layer + ": " + std::to_string(survey.no_id) + of + "hold no id (negative, NaN or beyond 32 bits) and count as 0");
  if (survey.mixed > 0)
    notes_.push_back(layer + ": " + std::to_string(survey.mixed) + of + "hold a mean of several ids: each takes the id of an unmixed pixel near it");
  if (survey.coarse > 0)
    notes_.push_back("warning: " + layer + ": " + std::to_string(survey.coarse) + of + "hold ids from " + std::to_string(exact_below(type_)) +
                     " up, where " + name_of(type_) + " samples do not tell every id from the next: objects may have merged");
}

std::uint32_t ObjectIds::plain_id(const std::string& called, const std::string& place) const {
  const std::optional<std::uint32_t> id = number_of(called);
  if (!id)
    throw Error(ErrorKind::input, place + ": " + in_marks(called) + " is a name, but layer " + in_marks(name_) +
                                      " holds numbers (0..4294967295; a Cryptomatte in \"ids\" holds names)");
  // The spacing of samples doubles with each doubling of the number.
  const std::uint32_t limit = exact_below(type_), spacing = *id < limit ? 1 : std::bit_floor(*id) / (limit / 2);
  if (*id % spacing != 0)
    throw Error(ErrorKind::input, place + ": layer " + in_marks(name_) + " cannot hold id " + called + ": its samples are " + name_of(type_) +
                                      ", which near it are " + std::to_string(spacing) + " apart (whole numbers are exact below " +
                                      std::to_string(limit) + ")");
  return *id;
}

std::vector<std::uint32_t> ObjectIds::ids_of(const std::vector<std::string>& called, const std::string& place) {
  std::vector<std::uint32_t> ids;
  std::map<std::uint32_t, std::string> hashed;  // ids of names that the manifest lacks
  for (const std::string& name : called) {
    const auto known = manifest_.ids.find(name);
    if (!cryptomatte_)
      ids.push_back(plain_id(name, place));
    else if (known != manifest_.ids.end())
      ids.push_back(known->second);
    else if (const auto digits = hexadecimal(name))
      ids.push_back(*digits);
    else if (!cryptomatte_->names_hash_to_ids)
      refuse_unknown(name, place);
    else
      hashed.emplace(ids.emplace_back(cryptomatte_id(name)), name);
  }
  const std::set<std::uint32_t> shown = hashed.empty() ? std::set<std::uint32_t>{} : occurring(hashed);
  for (const auto& [id, name] : hashed) {
    if (shown.contains(id)) continue;
    if (!manifest_.empty() && manifest_.notes.empty()) refuse_unknown(name, place);
    notes_.push_back("no pixel shows object " + in_marks(name) + ", and Cryptomatte " + in_marks(name_) + " has no manifest to check the name by");
  }
  return ids;
}

/// Those of the wanted ids that some pixel shows.
std::set<std::uint32_t> ObjectIds::occurring(const std::map<std::uint32_t, std::string>& wanted) const {
  std::set<std::uint32_t> found;
  std::vector<std::uint32_t> ids;
  for (const RoleLayer& level : cryptomatte_->levels) {
    const Window& all = file_->parts()[std::size_t(level.part)].data_window;
    const int rows = std::max(1, (1 << 22) / std::max(1, all.width()));  // four million ids: 16 MB
    for (int top = all.min_y; top < all.max_y; top += rows) {
      const Window band{all.min_x, top, all.max_x, std::min(top + rows, all.max_y)};
      for (std::size_t c = 0; c < level.channels.size(); c += 2) {
        ids.resize(std::size_t(band.pixels()));
        const Destination to{level.channels[c], SampleType::float32, ids.data(), sizeof(float), sizeof(float) * std::size_t(band.width())};
        file_->read(level.part, band, {&to, 1});
        for (const std::uint32_t id : ids)
          if (wanted.contains(id)) found.insert(id);
      }
    }
  }
  return found;
}

void ObjectIds::refuse_unknown(const std::string& called, const std::string& place) const {
  std::vector<std::string> names;
  for (const auto& [name, id] : manifest_.ids) names.push_back(name);
  const std::string near = near_names(called, names);
  throw Error(ErrorKind::input, place + ": Cryptomatte " + in_marks(name_) + " has no object " + in_marks(called) + " (" + near +
                                    (near.empty() ? "" : "; ") + "relume inspect lists them)");
}

std::string ObjectIds::called(std::uint32_t id) const {
  if (!cryptomatte_) return std::to_string(id);
  const auto known = manifest_.names.find(id);
  return known == manifest_.names.end() ? in_hexadecimal(id) : in_marks(known->second);
}

std::vector<std::uint32_t> ObjectIds::most_covering(const GBuffer& gbuffer) const {
  if (!cryptomatte_) return gbuffer.ids;
  std::vector<std::uint32_t> ids(gbuffer.planes.pixels());
  for_pixels(gbuffer, [&](std::size_t i) {
    float most = 0;  // ranks need not be in order: the specification lets a renderer put chosen objects first
    for_ranks(gbuffer, roles_, i, [&](std::uint32_t id, float coverage) {
      if (coverage <= most) return;
      most = coverage;
      ids[i] = id;
    });
  });
  return ids;
}

std::vector<float> ObjectIds::shares(const GBuffer& gbuffer, const std::set<std::uint32_t>& ids) const {
  std::vector<float> shares(gbuffer.planes.pixels());
  for_pixels(gbuffer, [&](std::size_t i) {
    if (!cryptomatte_) {
      shares[i] = ids.contains(gbuffer.ids[i]) ? 1.0f : 0.0f;
      return;
    }
    float chosen = 0, all = 0;
    for_ranks(gbuffer, roles_, i, [&](std::uint32_t id, float coverage) {
      all += coverage;
      chosen += ids.contains(id) ? coverage : 0;
    });
    shares[i] = all > 0 ? chosen / all : 0;
  });
  return shares;
}

void ObjectIds::count(const GBuffer& gbuffer, ObjectCounts& counts) const {
  constexpr std::size_t most = std::size_t(1) << 20;
  auto last = counts.end();
  const auto add = [&](std::uint32_t id, float coverage) {
    if (last == counts.end() || last->first != id) last = counts.size() < most ? counts.try_emplace(id).first : counts.find(id);
    if (last == counts.end()) return;
    ++last->second.pixels;
    last->second.coverage += double(coverage);
  };
  const float* const surface = gbuffer.planes.plane(gbuffer.coverage.first);
  for (std::size_t i = 0; i < gbuffer.planes.pixels(); ++i) {
    if (cryptomatte_)
      for_ranks(gbuffer, roles_, i, add);
    else if (surface[i] > 0)
      add(gbuffer.ids[i], surface[i]);
  }
}

}  // namespace relume
