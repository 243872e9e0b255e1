// Manifests are foreign text: read by events, so that depth and size cost nothing, and bounded.
#include "gbuffer/cryptomatte_manifest.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gbuffer/printable.h"

namespace relume {
namespace {

constexpr std::size_t most_names = std::size_t(1) << 20;         // productions have tens of thousands; this many take 200 MB
constexpr std::uintmax_t most_bytes = std::uintmax_t(64) << 20;  // as much as an attribute may hold

/// The id in hexadecimal; empty where it is none.
std::optional<std::uint32_t> id_of(const std::string& digits) {
  std::uint32_t id = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id, 16);
  if (digits.size() > 8 || error != std::errc() || end != digits.data() + digits.size()) return {};
  return id;
}

/// Takes names and ids from the outermost object; false from an event stops the parser.
class NameReader : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit NameReader(Manifest& manifest) : manifest_(manifest) {}

  std::size_t not_ids = 0;
  bool an_object = false, too_many = false;

  bool null() override { return other(); }
  bool boolean(bool) override { return other(); }
  bool number_integer(number_integer_t) override { return other(); }
  bool number_unsigned(number_unsigned_t) override { return other(); }
  bool number_float(number_float_t, const string_t&) override { return other(); }
  bool binary(binary_t&) override { return other(); }
  bool start_array(std::size_t) override { return other() && ++depth_ > 0; }
  bool end_array() override { return depth_-- > 0; }
  bool end_object() override { return depth_-- > 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

  bool start_object(std::size_t) override {
    an_object = an_object || depth_ == 0;
    return (depth_ == 0 || other()) && ++depth_ > 0;
  }
  bool key(string_t& name) override {
    if (depth_ == 1) name_ = std::move(name);
    return true;
  }
  bool string(string_t& value) override {
    if (depth_ != 1) return other();
    const std::optional<std::uint32_t> id = id_of(value);
    if (!id) return other();
    too_many = manifest_.ids.size() >= most_names;
    if (too_many) return false;
    manifest_.names.try_emplace(*id, name_);
    manifest_.ids.try_emplace(std::move(name_), *id);
    return true;
  }

 private:
  /// A value that is no id. One that is the whole text, in the place of the object, ends the parsing.
  bool other() {
    not_ids += depth_ == 1;
    return depth_ > 0;
  }

  Manifest& manifest_;
  std::string name_;
  int depth_ = 0;
};

/// What is wrong with a sidecar's name; empty if nothing is.
std::string problem_of(const std::string& name) {
  const std::filesystem::path path(name);
  if (path.is_absolute() || name.find(':') != std::string::npos) return "is not relative to the image";
  if (name.find('\\') != std::string::npos) return "has backslashes";
  for (const auto& step : path)
    if (step == ".." || step == ".") return "has a step to \"" + step.string() + '"';
  if (printable(name) != name) return "has characters that do not print";
  if (path.extension() != ".json") return "is no .json file";
  return {};
}

Manifest without_names(const std::string& note) { return {{}, {}, {}, {note}}; }

Manifest read_sidecar(const std::filesystem::path& exr, const std::string& name) {
  const std::string shown = "the manifest file \"" + printable(name) + '"';
  if (const std::string problem = problem_of(name); !problem.empty()) return without_names(shown + ' ' + problem + ": not opened");
  const std::filesystem::path file = exr.parent_path() / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return without_names(shown + " is not beside the image");
  if (std::filesystem::file_size(file, error) > most_bytes) return without_names(shown + " is larger than 64 MiB: not read");
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return without_names(shown + " could not be read");
  return parse_manifest(text, printable(name));
}

}  // namespace

Manifest parse_manifest(std::string_view json, const std::string& source) {
  Manifest manifest{{}, {}, source, {}};
  NameReader reader(manifest);
  const bool whole = nlohmann::json::sax_parse(json.begin(), json.end(), &reader);
  const std::string count = std::to_string(manifest.ids.size());
  const auto note = [&](const std::string& what) { manifest.notes.push_back("the manifest in " + source + ' ' + what); };
  if (reader.too_many)
    note("has more than " + count + " names: the rest is left out");
  else if (!reader.an_object)
    note("is no JSON object: names are hashed instead");
  else if (!whole)
    note("is not valid JSON after " + count + " names: others are hashed instead");
  if (reader.an_object && reader.not_ids > 0)
    note("has " + std::to_string(reader.not_ids) + " values that are no ids of 8 hexadecimal digits: left out");
  return manifest;
}

Manifest read_manifest(const std::filesystem::path& exr, const std::optional<std::string>& in_header, const std::optional<std::string>& sidecar) {
  Manifest manifest;
  if (sidecar) manifest = read_sidecar(exr, *sidecar);
  if (!manifest.source.empty() || !in_header) return manifest;
  Manifest header = parse_manifest(*in_header, "the header");
  header.notes.insert(header.notes.begin(), manifest.notes.begin(), manifest.notes.end());
  return header;
}

}  // namespace relume
