// Strict JSON that remembers lines, on nlohmann's parser: its iterator counts what was consumed, which is where a value stands.
#include "host/json.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "gbuffer/error.h"
#include "gbuffer/watched.h"

namespace relume {
namespace {

constexpr std::size_t deepest = 64;  // deeper than any rig; keeps destructors and readers off the end of the stack

/// Walks over text and counts, in a place that all copies share, because the parser keeps its own copy.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::size_t* consumed;

  const char& operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*consumed;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
};

/// The token, which may have space before it, is where a comment would begin.
bool begins_comment(std::string_view token) {
  if (!token.ends_with('/') && !token.ends_with('#')) return false;
  return token.size() == 1 || !std::isalnum(static_cast<unsigned char>(token[token.size() - 2]));
}

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::size_t consumed = 0;
  Json root;

  bool null() override { return add(Json::Type::null), true; }
  bool boolean(bool value) override { return add(Json::Type::boolean).boolean = value, true; }
  bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
  bool string(string_t& value) override { return add(Json::Type::string).string = std::move(value), true; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::Type::object); }
  bool start_array(std::size_t) override { return open(Json::Type::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override;
  bool parse_error(std::size_t, const std::string& last_token, const nlohmann::detail::exception& error) override;

 private:
  struct Open {
    Json* value;
    std::unordered_set<std::string> keys;
  };

  [[noreturn]] void fail(int line, const std::string& what) const { throw Error(ErrorKind::input, file_ + ":" + std::to_string(line) + ": " + what); }

  /// The line of the last consumed character; without it where the parser has looked one character ahead.
  int line(bool looked_ahead) {
    const std::size_t end = looked_ahead && consumed > 0 ? consumed - 1 : consumed;
    for (; counted_ < end; ++counted_) line_ += text_[counted_] == '\n';
    return line_;
  }

  Json& add(Json::Type type, bool looked_ahead = false) {
    Json* place = &root;
    if (!open_.empty()) {
      Json& parent = *open_.back().value;
      place = parent.type == Json::Type::array ? &parent.items.emplace_back() : &parent.members.back().value;
    }
    place->type = type;
    place->line = line(looked_ahead);
    return *place;
  }
  bool add_number(double value) { return add(Json::Type::number, true).number = value, true; }  // a number ends where something else begins
  bool open(Json::Type type) {
    Json& value = add(type);
    if (open_.size() == deepest) fail(value.line, "nested too deeply (" + std::to_string(deepest) + " levels are allowed)");
    open_.push_back({&value, {}});
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  std::string file_;
  std::vector<Open> open_;  // pointers into the tree stay good: only the innermost open value grows
  std::size_t counted_ = 0;
  int line_ = 1;
};

bool TreeBuilder::key(string_t& name) {
  const int here = line(false);
  if (!open_.back().keys.insert(name).second) fail(here, "key " + in_quotes(name) + " is given twice");
  open_.back().value->members.push_back({std::move(name), here, {}});
  return true;
}

bool TreeBuilder::parse_error(std::size_t, const std::string& last_token, const nlohmann::detail::exception& error) {
  const int here = line(true);
  const std::string what = error.what();
  if (what.find("number overflow") != std::string::npos) fail(here, "number " + last_token + " is beyond the range of a double");
  if (what.find("UTF-8") != std::string::npos) fail(here, "not valid UTF-8");
  if (begins_comment(last_token)) fail(here, "comments are not allowed in JSON");
  const std::size_t dash = what.find(" - ");  // after "[json.exception...] parse error at line 1, column 2: syntax error while parsing value"
  fail(here, "not JSON: " + (dash == std::string::npos ? what : what.substr(dash + 3)));
}

std::string_view type_name(Json::Type type) {
  constexpr std::string_view names[] = {"null", "a boolean", "a number", "a string", "an array", "an object"};
  return names[static_cast<int>(type)];
}

std::string wrong_type(const std::string& wanted, const Json& got) { return "must be " + wanted + " (is " + std::string(type_name(got.type)) + ")"; }

}  // namespace

const Json* Json::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member.value;
  return nullptr;
}

std::string shown(const std::filesystem::path& file) { return file == "-" ? "standard input" : file.string(); }

std::string read_text(const std::filesystem::path& file) {
  if (file == "-") {
    watched().input_used = true;
    return {std::istreambuf_iterator<char>(std::cin), {}};
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw Error(ErrorKind::input, file.string() + ": is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(ErrorKind::input, file.string() + (std::filesystem::exists(file, ignored) ? ": may not be read" : ": no such file"));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw Error(ErrorKind::input, file.string() + ": could not be read to its end");
  return text;
}

Json parse_json(std::string_view text, const std::string& file) {
  TreeBuilder builder(text, file);
  const CountingIterator begin{text.data(), &builder.consumed}, end{text.data() + text.size(), &builder.consumed};
  nlohmann::json::sax_parse(begin, end, &builder);  // strict: nothing may follow; every error is thrown by the builder
  return std::move(builder.root);
}

std::string in_quotes(std::string_view text) { return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

std::string in_digits(double number) {
  char digits[32];
  const bool plain = number == 0 || (std::abs(number) >= 1e-5 && std::abs(number) < 1e15);  // else an exponent is easier to read
  const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
  return {digits, std::to_chars(digits, digits + sizeof digits, number, format).ptr};
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string list;
  for (const std::string_view word : words) {
    if (!list.empty()) list += ", ";
    list += word;
  }
  return list;
}

ObjectReader::ObjectReader(const Json& json, std::string file, std::string place) : json_(json), file_(std::move(file)), place_(std::move(place)) {
  if (json.type != Json::Type::object) fail(json.line, wrong_type("an object", json));
}

void ObjectReader::allow(const std::vector<std::string_view>& keys) const {
  for (const Json::Member& member : json_.members)
    if (std::find(keys.begin(), keys.end(), member.key) == keys.end())
      fail(member.line, "unknown key " + in_quotes(member.key) + " (has: " + listed(keys) + ")");
}

void ObjectReader::need_version() const {
  need("relume");
  if (number("relume") != 1) fail("relume", "this version of the file is not known (1 is)");
}

const Json& ObjectReader::need(std::string_view key) const {
  if (const Json* value = json_.find(key)) return *value;
  fail(json_.line, in_quotes(key) + " is missing");
}

std::optional<double> ObjectReader::number(std::string_view key) const {
  const Json* value = json_.find(key);
  if (!value) return {};
  if (value->type != Json::Type::number) fail(key, wrong_type("a number", *value));
  return value->number;
}

std::optional<bool> ObjectReader::boolean(std::string_view key) const {
  const Json* value = json_.find(key);
  if (!value) return {};
  if (value->type != Json::Type::boolean) fail(key, wrong_type("true or false", *value));
  return value->boolean;
}

std::optional<std::string> ObjectReader::string(std::string_view key) const {
  const Json* value = json_.find(key);
  if (!value) return {};
  if (value->type != Json::Type::string) fail(key, wrong_type("a string", *value));
  return value->string;
}

std::optional<std::vector<double>> ObjectReader::numbers(std::string_view key, std::size_t count, bool grey) const {
  const Json* value = json_.find(key);
  if (!value) return {};
  if (grey && value->type == Json::Type::number) return std::vector<double>(count, value->number);
  const std::string wanted = (grey ? "1 or " : "") + std::to_string(count) + " numbers";
  if (value->type != Json::Type::array) fail(key, wrong_type(wanted, *value));
  if (value->items.size() != count) fail(key, "must be " + wanted + " (has " + std::to_string(value->items.size()) + ")");
  std::vector<double> numbers;
  for (const Json& item : value->items) {
    if (item.type != Json::Type::number) fail(item.line, in_quotes(key) + ": " + wrong_type(wanted, item));
    numbers.push_back(item.number);
  }
  return numbers;
}

std::optional<std::size_t> ObjectReader::choice(std::string_view key, const std::vector<std::string_view>& words) const {
  const std::optional<std::string> word = string(key);
  if (!word) return {};
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == *word) return i;
  fail(key, "must be one of " + listed(words));
}

void ObjectReader::fail(std::string_view key, const std::string& what) const {
  const Json* value = json_.find(key);
  fail(value ? value->line : json_.line, in_quotes(key) + ": " + what);
}

void ObjectReader::fail(int line, const std::string& what) const {
  throw Error(ErrorKind::input, file_ + ":" + std::to_string(line) + ": " + (place_.empty() ? "" : place_ + ": ") + what);
}

}  // namespace relume
