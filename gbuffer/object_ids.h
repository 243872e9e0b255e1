// Which object a pixel shows, and how much of the pixel: from a layer of whole numbers or from a Cryptomatte.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gbuffer/cryptomatte.h"
#include "gbuffer/gbuffer.h"

namespace relume {

struct ObjectCount {
  std::int64_t pixels = 0;  ///< that show something of it
  double coverage = 0;      ///< sum over pixels of what it covers of each
};
using ObjectCounts = std::map<std::uint32_t, ObjectCount>;  ///< by id

/// The layer that a material file or a rig takes its objects from.
class ObjectIds {
 public:
  /// `name`: an id layer or a Cryptomatte, in any spelling, or empty: the one that the reading has for ids, else, and where `by_names` says that
  /// objects are called by names, the Cryptomatte of objects. Its layers are added to `reading.roles`. Throws Error{input} that lists what there is.
  /// `file` must outlive it.
  ObjectIds(const ExrFile& file, Reading& reading, const std::string& name, bool by_names);

  const std::string& name() const { return name_; }
  bool is_cryptomatte() const { return cryptomatte_.has_value(); }
  std::size_t ranks() const { return cryptomatte_ ? cryptomatte_->ranks() : 1; }
  const Manifest& manifest() const { return manifest_; }
  /// For read_gbuffer.
  const std::vector<std::string>& roles() const { return roles_; }
  /// What was found out about the ids, one sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The ids of objects called as a person does: by number, or in a Cryptomatte by name or "0x" and 8 hexadecimal digits. A name that the manifest
  /// lacks is hashed, and some pixel has to show it where there is a manifest. Throws Error{input} that begins with `place` and lists names that
  /// are near.
  std::vector<std::uint32_t> ids_of(const std::vector<std::string>& called, const std::string& place);
  /// The object's name in quotes, or its number.
  std::string called(std::uint32_t id) const;

  /// The object that covers most of each pixel; 0 where none does.
  std::vector<std::uint32_t> most_covering(const GBuffer& gbuffer) const;
  /// The share that these objects have of all that each pixel shows, 0..1.
  std::vector<float> shares(const GBuffer& gbuffer, const std::set<std::uint32_t>& ids) const;
  /// Adds a band's objects; of a file with more than a million ids (noise, not ids) those that come first.
  void count(const GBuffer& gbuffer, ObjectCounts& counts) const;

 private:
  void take_cryptomatte(const Cryptomatte& cryptomatte, Reading& reading);
  void take_plain(Reading& reading);
  void note_coarse_ids(const Reading& reading);
  std::uint32_t plain_id(const std::string& called, const std::string& place) const;
  std::set<std::uint32_t> occurring(const std::map<std::uint32_t, std::string>& wanted) const;
  [[noreturn]] void refuse_unknown(const std::string& called, const std::string& place) const;

  const ExrFile* file_;  ///< never null
  std::string name_;
  std::optional<Cryptomatte> cryptomatte_;
  Manifest manifest_;
  SampleType type_ = SampleType::uint32;  ///< of plain ids
  std::vector<std::string> roles_, notes_;
};

}  // namespace relume
