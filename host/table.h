// A table of text with a header, as CSV: what `relume evaluate` reads and adds to.
#pragma once

#include <string>
#include <vector>

namespace relume {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// Its position, or -1.
  int column(const std::string& name) const;
  /// The column as numbers. Throws Error{input} naming line and column where a field is none.
  std::vector<double> numbers(int column) const;
};

/// RFC 4180: commas, fields in double quotes may hold commas and doubled quotes. Throws Error{input} naming the line.
Table parse_table(const std::string& text);

/// Quotes where needed.
std::string to_text(const Table& table);

}  // namespace relume
