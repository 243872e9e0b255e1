// SampleTable: the BRDF's name, its parameters, then numbers.
#include "lab/sample_table.h"

#include <cstdio>

#include "lab/measure.h"

namespace relume {
namespace {

/// RFC 4180: three components have commas.
std::string field(const std::string& text) { return text.find(',') == std::string::npos ? text : '"' + text + '"'; }

}  // namespace

std::string nine_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

SampleTable::SampleTable(const Comparison& comparison, const std::vector<std::string>& places, const std::vector<std::string>& values)
    : comparison_(comparison), text_("brdf") {
  for (const Sweep& sweep : comparison.sweeps) text_ += ',' + sweep.parameter;
  for (const auto* columns : {&places, &values})
    for (const std::string& column : *columns) text_ += ',' + column;
  text_ += '\n';
}

void SampleTable::add(const Subject& subject, const std::vector<double>& places, const std::vector<double>& values) {
  text_ += subject.brdf;
  for (const Sweep& sweep : comparison_.sweeps) text_ += ',' + field(subject.value(sweep.parameter));
  for (const auto* numbers : {&places, &values})
    for (const double number : *numbers) text_ += ',' + nine_digits(number);
  text_ += '\n';
}

std::vector<std::string> brdf_columns() {
  std::vector<std::string> columns;
  for (const char* quantity : {"f_r", "reflectance"})
    for (const char* part : {"", ".diffuse", ".specular"})
      for (const char* channel : {".r", ".g", ".b"}) columns.push_back(std::string(quantity) + part + channel);
  return columns;
}

std::vector<double> brdf_values(const Reflectance& value, double n_l) {
  std::vector<double> numbers;
  for (const bool divided : {true, false})
    for (const LobePart part : {LobePart::total, LobePart::diffuse, LobePart::specular})
      for (int c = 0; c < 3; ++c) numbers.push_back(part_of(value, part)[c] / (divided && n_l > 0 ? n_l : 1));
  return numbers;
}

}  // namespace relume
