// evaluate_table: rows as the pixels of a made-up band, columns as its layers.
#include "host/evaluate.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "gbuffer/error.h"
#include "host/binding.h"
#include "host/brdf_name.h"
#include "host/device_opening.h"
#include "host/lobes.h"
#include "host/row_band.h"
#include "host/self_test.h"
#include "host/table.h"
#include "host/twin.h"

namespace relume {
namespace {

Material material_of(const std::string& brdf, const std::vector<std::string>& set, const std::vector<std::string>& columns) {
  Material material = material_named(brdf);
  for (const std::string& assignment : set) set_parameter(material, assignment);
  // A column counts as given, so that eta and k mean a conductor, as they do in a material file.
  for (const std::string& column : columns) material.parameters[column] = LayerValue{column};
  check(material, "table");
  return material;
}

RowBand rows_of(const Table& table) {
  std::array<std::vector<double>, 3> columns;
  const std::array names{"n_l", "n_v", "l_v"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int column = table.column(names[k]);
    if (column < 0) throw Error(ErrorKind::input, std::string("stdin: no column ") + names[k] + " (n_l, n_v and l_v are needed)");
    columns[k] = table.numbers(column);
  }
  std::vector<PreciseCosines> cosines;
  for (std::size_t i = 0; i < table.rows.size(); ++i) cosines.push_back(precise_cosines(columns[0][i], columns[1][i], columns[2][i]));
  return RowBand(cosines);
}

/// The parameters that have columns, which go into the rows.
std::vector<std::string> add_parameters(const Table& table, RowBand& rows) {
  std::vector<std::string> found;
  for (const std::string_view parameter : parameter_names()) {
    const std::string name(parameter);
    if (parameter_named(parameter).is_file) continue;
    std::vector<int> columns{table.column(name + ".r"), table.column(name + ".g"), table.column(name + ".b")};
    if (*std::min_element(columns.begin(), columns.end()) < 0) columns = {table.column(name)};
    if (columns[0] < 0) continue;
    std::vector<std::vector<double>> values;
    for (const int column : columns) values.push_back(table.numbers(column));
    rows.add_parameter(name, values);
    found.push_back(name);
  }
  return found;
}

std::string nine_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

std::string evaluate_table(const std::string& brdf, const std::vector<std::string>& set, const std::string& device, const std::string& text) {
  Table table = parse_table(text);
  RowBand rows = rows_of(table);
  const Material material = material_of(brdf, set, add_parameters(table, rows));
  const LayerFinder no_layers = [](const std::string& layer) -> RoleLayer {
    throw Error(ErrorKind::input, "--set: no layer \"" + layer + "\": a table has columns");
  };
  const Binding binding(material, {}, "stdin", no_layers, rows.reading());
  const std::unique_ptr<Device> opened = open_device_or_twin(device);
  if (opened->info().name != "twin") self_test(*opened, binding.programs().front());
  const Planes out = rows.evaluate(*opened, binding);
  const std::vector<double> n_l = table.numbers(table.column("n_l"));
  std::vector<std::array<double, 3>> reflectance(table.rows.size());
  bool coloured = false;
  for (std::size_t i = 0; i < reflectance.size(); ++i) {
    for (int c = 0; c < 3; ++c) reflectance[i][std::size_t(c)] = double(out.plane(c)[i]) + double(out.plane(3 + c)[i]);
    coloured = coloured || reflectance[i][0] != reflectance[i][1] || reflectance[i][0] != reflectance[i][2];
  }
  for (const char* name : {"f_r", "reflectance"})
    for (const char* channel : coloured ? std::vector{".r", ".g", ".b"} : std::vector{""}) table.columns.push_back(std::string(name) + channel);
  for (std::size_t i = 0; i < reflectance.size(); ++i)
    for (const bool divided : {true, false})
      for (std::size_t c = 0; c < (coloured ? 3u : 1u); ++c)
        table.rows[i].push_back(nine_digits(divided ? (n_l[i] > 0 ? reflectance[i][c] / n_l[i] : 0) : reflectance[i][c]));
  return to_text(table);
}

}  // namespace relume
