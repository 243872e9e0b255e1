// Names that came from a file, made safe to print: no control characters, no invalid UTF-8, one line.
#pragma once

#include <string>
#include <string_view>

namespace relume {

/// Control characters, invalid UTF-8, line separators and text-direction marks become escapes (\n, \x1b, \u202e); a backslash is doubled.
std::string printable(std::string_view text);

/// The same for a sentence in which names were made printable already: backslashes stay as they are.
std::string printable_sentence(std::string_view text);

}  // namespace relume
