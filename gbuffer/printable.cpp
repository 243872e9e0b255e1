// Escapes by UTF-8's well-formed byte sequences (Unicode 15, table 3-7).
#include "gbuffer/printable.h"

#include <cstdint>
#include <cstdio>

namespace relume {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: no well-formed sequence starts here
};

Character decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7f >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const std::uint32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;  // an overlong form hides a character from filters
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < least || code > 0x10ffff || surrogate) return {};
  return {code, bytes};
}

bool harmless(std::uint32_t code) {
  if (code < 0x20 || (code >= 0x7f && code < 0xa0) || code == '\\') return false;
  if (code == 0x2028 || code == 0x2029) return false;                                                   // line and paragraph separators
  if (code == 0x200e || code == 0x200f || code == 0x061c) return false;                                 // direction marks
  return !(code >= 0x202a && code <= 0x202e) && !(code >= 0x2066 && code <= 0x2069) && code != 0xfeff;  // direction overrides, isolates; BOM
}

std::string escaped(std::uint32_t code) {
  if (code == '\\') return "\\\\";
  if (code == '\n') return "\\n";
  char text[16];
  std::snprintf(text, sizeof text, code < 0x80 ? "\\x%02x" : "\\u%04x", code);
  return text;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Character character = decode(text);
    if (character.bytes == 0) {
      char hex[8];
      std::snprintf(hex, sizeof hex, "\\x%02x", static_cast<std::uint8_t>(text[0]));
      out += hex;
      text.remove_prefix(1);
      continue;
    }
    if (harmless(character.code))
      out += text.substr(0, character.bytes);
    else
      out += escaped(character.code);
    text.remove_prefix(character.bytes);
  }
  return out;
}

std::string printable_sentence(std::string_view text) {
  std::string out;
  for (std::size_t backslash; (backslash = text.find('\\')) != std::string_view::npos; text.remove_prefix(backslash + 1))
    out += printable(text.substr(0, backslash)) + '\\';
  return out + printable(text);
}

}  // namespace relume
