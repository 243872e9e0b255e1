// near_names: by Levenshtein's distance, case aside; a name that holds the other is near too.
#include "gbuffer/near_names.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>

#include "gbuffer/printable.h"

namespace relume {
namespace {

constexpr std::size_t shown = 5;         // a line is read by a person
constexpr std::size_t longest = 200;     // longer names are paths; their distance costs its square
constexpr std::size_t examined = 50000;  // a tenth of a second

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Insertions, deletions and replacements that make one the other (Levenshtein 1965).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, replaced}));
    }
  }
  return row.back();
}

/// How far they are apart; beyond `limit` for what is not near.
std::size_t apart(const std::string& a, const std::string& b, std::size_t limit) {
  if (a.empty() || b.empty()) return limit + 1;
  if (a.find(b) != std::string::npos || b.find(a) != std::string::npos) return limit;
  const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
  return difference > limit || std::max(a.size(), b.size()) > longest ? limit + 1 : distance(a, b);
}

std::string listed(const std::vector<std::string>& names, std::size_t all) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + printable(name) + '"';
  return all > names.size() ? text + ", and " + std::to_string(all - names.size()) + " more" : text;
}

}  // namespace

std::string near_names(const std::string& name, const std::vector<std::string>& names) {
  const std::string wanted = lower(name);
  const std::size_t limit = 1 + wanted.size() / 4;  // "torsu" for "torus" is two apart
  std::vector<std::pair<std::size_t, std::string>> near;
  for (std::size_t i = 0; i < std::min(names.size(), examined); ++i)
    if (const std::size_t far = apart(wanted, lower(names[i]), limit); far <= limit) near.emplace_back(far, names[i]);
  std::sort(near.begin(), near.end());
  std::vector<std::string> first;
  for (std::size_t i = 0; i < std::min(near.size(), shown); ++i) first.push_back(near[i].second);
  if (!first.empty()) return "near: " + listed(first, first.size());
  first.assign(names.begin(), names.begin() + std::ptrdiff_t(std::min(names.size(), shown)));
  return first.empty() ? std::string() : "has: " + listed(first, names.size());
}

}  // namespace relume
