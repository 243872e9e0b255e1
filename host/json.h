// Strict JSON that remembers lines: every error names the file, the line and the key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relume {

/// A JSON value and the line that it stands on.
struct Json {
  enum class Type { null, boolean, number, string, array, object };
  struct Member;

  Type type = Type::null;
  int line = 0;  ///< of its last token's start; arrays and objects: of the opening bracket
  bool boolean = false;
  double number = 0;  ///< finite
  std::string string;
  std::vector<Json> items;      ///< of an array
  std::vector<Member> members;  ///< of an object, in the file's order; keys are unique

  /// Null where an object has no such key.
  const Json* find(std::string_view key) const;
};

struct Json::Member {
  std::string key;
  int line = 0;
  Json value;
};

/// Reads a whole file; "-" is standard input. Error{input} where it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// How errors name a file: its path, and "standard input" for "-".
std::string shown(const std::filesystem::path& file);

/// Error{input} "file:line: ..." on anything that RFC 8259 does not allow, and on duplicate keys, numbers beyond double and nesting deeper than 64.
Json parse_json(std::string_view text, const std::string& file);

/// In quotes, with control characters escaped: an error stays one line.
std::string in_quotes(std::string_view text);

/// The fewest digits that give the number back: "0.1", "1e+20".
std::string in_digits(double number);

/// "a, b, c"
std::string listed(const std::vector<std::string_view>& words);

/// Reads the members of one object and says what is wrong with them: `rig.json:12: lights[3]: "cone": must be one of gltf, smoothstep, linear`.
class ObjectReader {
 public:
  /// Keeps references. `place` is how to get there ("lights[3]"), empty for the whole file. Error{input} unless `json` is an object.
  ObjectReader(const Json& json, std::string file, std::string place);

  /// Error{input} for the first key that is not among them.
  void allow(const std::vector<std::string_view>& keys) const;
  /// Error{input} unless "relume" is 1: the version of rig and material files.
  void need_version() const;

  bool has(std::string_view key) const { return json_.find(key) != nullptr; }
  const Json& need(std::string_view key) const;

  /// Empty where the key is absent; Error{input} where its value has another type.
  std::optional<double> number(std::string_view key) const;
  std::optional<bool> boolean(std::string_view key) const;
  std::optional<std::string> string(std::string_view key) const;
  /// Exactly `count` numbers, or one that stands for all of them where `grey` says so.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count, bool grey = false) const;
  /// The place of the value among `words`.
  std::optional<std::size_t> choice(std::string_view key, const std::vector<std::string_view>& words) const;

  /// Throws Error{input} about a key's value, or about the object where it has no such key.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;
  [[noreturn]] void fail(int line, const std::string& what) const;

  const Json& json() const { return json_; }
  const std::string& place() const { return place_; }

 private:
  const Json& json_;
  std::string file_, place_;
};

}  // namespace relume
