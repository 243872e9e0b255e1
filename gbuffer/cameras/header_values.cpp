// HeaderValues: attributes of any type as numbers.
#include "gbuffer/cameras/header_values.h"

#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace relume {
namespace {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

/// "[1.0, 0.0]", "1 0", "(1;0)": numbers and what people put between them; anything else is no list of numbers.
std::vector<double> numbers_in(std::string_view text) {
  constexpr std::size_t longest = 4096;  // bytes: a matrix in 17 digits takes a tenth of it
  if (text.size() > longest) return {};
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  while (at != end) {
    if (std::string_view(" \t\r\n,;+[](){}").find(*at) != std::string_view::npos) {
      ++at;
      continue;
    }
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) return {};
    numbers.push_back(number);
    at = next;
  }
  return numbers;
}

template <class Value>
const Value* value_of(const Imf::Attribute& attribute) {
  const auto* const typed = dynamic_cast<const Imf::TypedAttribute<Value>*>(&attribute);
  return typed ? &typed->value() : nullptr;
}

template <class Matrix>
std::vector<double> elements(const Matrix& matrix) {
  return {&matrix.x[0][0], &matrix.x[0][0] + 16};
}

std::vector<double> numbers_of(const Imf::Attribute& attribute) {
  if (const auto* v = value_of<float>(attribute)) return {*v};
  if (const auto* v = value_of<double>(attribute)) return {*v};
  if (const auto* v = value_of<int>(attribute)) return {double(*v)};
  if (const auto* v = value_of<Imath::V2f>(attribute)) return {v->x, v->y};
  if (const auto* v = value_of<Imath::V2d>(attribute)) return {v->x, v->y};
  if (const auto* v = value_of<Imath::V3f>(attribute)) return {v->x, v->y, v->z};
  if (const auto* v = value_of<Imath::V3d>(attribute)) return {v->x, v->y, v->z};
  if (const auto* v = value_of<Imath::M44f>(attribute)) return elements(*v);
  if (const auto* v = value_of<Imath::M44d>(attribute)) return elements(*v);
  if (const auto* v = value_of<Imf::FloatVector>(attribute)) return {v->begin(), v->end()};
  if (const auto* v = value_of<std::string>(attribute)) return numbers_in(*v);
  return {};
}

}  // namespace

HeaderValues::HeaderValues(const Imf::Header& header) : header_(header) {
  for (const bool prefixed : {false, true})  // an attribute of the plain name comes first
    for (auto i = header.begin(); i != header.end(); ++i) {
      std::string name = lower(i.name());
      bool stripped = false;
      for (const char* prefix : {"nuke/exr/", "exr/"})
        if (!stripped && name.starts_with(prefix)) name = name.substr(std::string_view(prefix).size()), stripped = true;
      if (stripped == prefixed) attributes_.emplace(name, &i.attribute());
    }
}

const Imf::Attribute* HeaderValues::find(const std::string& name) const {
  const auto found = attributes_.find(lower(name));
  return found == attributes_.end() ? nullptr : found->second;
}

std::optional<std::vector<double>> HeaderValues::numbers(const std::string& name, std::size_t count) const {
  const Imf::Attribute* const attribute = find(name);
  if (!attribute) return {};
  std::vector<double> numbers = numbers_of(*attribute);
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
  return numbers.size() == count && finite ? std::optional(std::move(numbers)) : std::nullopt;
}

std::optional<double> HeaderValues::number(const std::string& name) const {
  const auto one = numbers(name, 1);
  return one ? std::optional(one->front()) : std::nullopt;
}

std::string HeaderValues::text(const std::string& name) const {
  const Imf::Attribute* const attribute = find(name);
  const auto* const text = attribute ? value_of<std::string>(*attribute) : nullptr;
  return text ? *text : "";
}

std::vector<std::string> HeaderValues::names(const std::string& begin, const std::string& end) const {
  std::vector<std::string> names;
  for (const auto& [name, attribute] : attributes_)
    if (name.size() >= begin.size() + end.size() && name.starts_with(lower(begin)) && name.ends_with(lower(end))) names.push_back(name);
  return names;
}

double HeaderValues::pixel_aspect() const {
  const double aspect = header_.pixelAspectRatio();
  return std::isfinite(aspect) && aspect > 0 ? aspect : 1;
}

}  // namespace relume
