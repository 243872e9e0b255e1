// Table: RFC 4180 in both directions.
#include "host/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gbuffer/error.h"

namespace relume {
namespace {

std::vector<std::string> fields_of(const std::string& line, std::size_t number) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  if (quoted) throw Error(ErrorKind::input, "stdin:" + std::to_string(number) + ": a quote is not closed");
  return fields;
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace

int Table::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  return found == columns.end() ? -1 : int(found - columns.begin());
}

std::vector<double> Table::numbers(int column) const {
  std::vector<double> values;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::string& field = rows[row][std::size_t(column)];
    const std::size_t begin = std::min(field.find_first_not_of(" +\t"), field.size());
    double value = 0;
    const auto [end, status] = std::from_chars(field.data() + begin, field.data() + field.size(), value);
    if (status != std::errc() || field.find_first_not_of(" \t", std::size_t(end - field.data())) != std::string::npos || !std::isfinite(value))
      throw Error(ErrorKind::input,
                  "stdin:" + std::to_string(row + 2) + ": column " + columns[std::size_t(column)] + ": \"" + field + "\" is no finite number");
    values.push_back(value);
  }
  return values;
}

Table parse_table(const std::string& text) {
  Table table;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    std::vector<std::string> fields = fields_of(line, number);
    if (table.columns.empty()) {
      table.columns = std::move(fields);
    } else if (fields.size() != table.columns.size()) {
      throw Error(ErrorKind::input, "stdin:" + std::to_string(number) + ": " + std::to_string(fields.size()) + " fields, the header has " +
                                        std::to_string(table.columns.size()));
    } else {
      table.rows.push_back(std::move(fields));
    }
  }
  if (table.columns.empty()) throw Error(ErrorKind::input, "stdin: no header line (n_l,n_v,l_v and what parameters vary)");
  return table;
}

std::string to_text(const Table& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i ? "," : "") + quoted(fields[i]);
    text += "\n";
  };
  add(table.columns);
  for (const auto& row : table.rows) add(row);
  return text;
}

}  // namespace relume
