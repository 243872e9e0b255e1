// evaluate_table: rows as the pixels of a made-up band, columns as its layers.
#include "host/evaluate.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "gbuffer/error.h"
#include "host/binding.h"
#include "host/cosines.h"
#include "host/device.h"
#include "host/lobes.h"
#include "host/self_test.h"
#include "host/table.h"
#include "host/twin.h"

namespace relume {
namespace {

/// The lobes of one name: one half, or both.
Material material_of(const std::string& brdf, const std::vector<std::string>& set, const std::vector<std::string>& columns) {
  Material material;
  material.diffuse = find_lobe(true, brdf) ? brdf : "none";
  material.specular = find_lobe(false, brdf) ? brdf : "none";
  if (material.diffuse == "none" && material.specular == "none") {
    std::string names;
    for (const bool diffuse : {true, false})
      for (const std::string_view name : names_of(diffuse ? diffuse_lobes() : specular_lobes()))
        names += (names.empty() ? "" : ", ") + std::string(name);
    throw Error(ErrorKind::input, "no BRDF \"" + brdf + "\" (has: " + names + ")");
  }
  for (const std::string& assignment : set) set_parameter(material, assignment);
  // A column counts as given, so that eta and k mean a conductor, as they do in a material file.
  for (const std::string& column : columns) material.parameters[column] = LayerValue{column};
  check(material, "table");
  return material;
}

/// Rows as pixels: cosines in the planes from `position`, every parameter's column as a role.
class RowBand {
 public:
  explicit RowBand(const Table& table)
      : gbuffer_{{0, 0, int(table.rows.size()), 1}, Planes(table.rows.size(), planes), {}, {}, {}, {}, false, {}, {}, 0, 0} {
    place_cosines(table);
    gbuffer_.coverage = {gbuffer_.planes.add(), 1};
    std::fill_n(gbuffer_.planes.plane(gbuffer_.coverage.first), table.rows.size(), 1.0f);
    for (const std::string_view name : parameter_names()) place_parameter(table, std::string(name));
  }

  /// The parameters that have columns.
  const std::vector<std::string>& parameters() const { return parameters_; }
  GBuffer& gbuffer() { return gbuffer_; }
  Reading& reading() { return reading_; }

 private:
  static constexpr int planes = 256;  // two for each parameter's component at most, and the cosines

  void place_cosines(const Table& table) {
    std::array<std::vector<double>, 3> columns;
    const std::array names{"n_l", "n_v", "l_v"};
    for (std::size_t k = 0; k < names.size(); ++k) {
      const int column = table.column(names[k]);
      if (column < 0) throw Error(ErrorKind::input, std::string("stdin: no column ") + names[k] + " (n_l, n_v and l_v are needed)");
      columns[k] = table.numbers(column);
    }
    gbuffer_.position = {gbuffer_.planes.add(9), 9};
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const PreciseCosines c = precise_cosines(columns[0][i], columns[1][i], columns[2][i]);
      const double values[] = {c.n_l, c.n_v, c.l_v, c.sum2, c.across2, c.along2, c.tan2_h, c.chord2, c.r_l};
      for (int k = 0; k < 9; ++k) gbuffer_.planes.plane(gbuffer_.position.first + k)[i] = float(values[k]);
    }
  }

  void place_parameter(const Table& table, const std::string& name) {
    const int grey = table.column(name);
    const std::array colour{table.column(name + ".r"), table.column(name + ".g"), table.column(name + ".b")};
    const bool coloured = *std::min_element(colour.begin(), colour.end()) >= 0;
    if (grey < 0 && !coloured) return;
    parameters_.push_back(name);
    // Cycles' `albedo` is the kernel's base colour (host/lobes.h).
    for (const std::string& role : name == "albedo" ? std::vector<std::string>{"albedo", "base_color"} : std::vector<std::string>{name}) {
      const PlaneRange range{gbuffer_.planes.add(coloured ? 3 : 1), coloured ? 3 : 1};
      for (int c = 0; c < range.count; ++c) {
        const std::vector<double> values = table.numbers(coloured ? colour[std::size_t(c)] : grey);
        std::copy(values.begin(), values.end(), gbuffer_.planes.plane(range.first + c));
      }
      gbuffer_.roles[role] = range;
      reading_.roles[role] = {};
    }
  }

  GBuffer gbuffer_;
  Reading reading_;
  std::vector<std::string> parameters_;
};

/// Diffuse and specular planes of all rows.
Planes shade_rows(RowBand& rows, const Binding& binding, const std::string& selector) {
  const std::unique_ptr<Device> device = open_device(selector.empty() && list_devices().empty() ? "twin" : selector);
  if (device->info().name != "twin") self_test(*device, binding.programs().front());
  GBuffer& gbuffer = rows.gbuffer();
  Frame frame{};
  frame.pixels = int(gbuffer.window.pixels());
  frame.plane_stride = int(gbuffer.planes.stride());
  frame.position = gbuffer.position.first;
  frame.base_normal = -1;
  frame.total = frame.ambient_out = -1;
  frame.diffuse = 0;
  frame.specular = 3;
  binding.bind(gbuffer, Camera{}, frame);
  Planes out(gbuffer.planes.pixels(), 6);
  out.add(6);
  frame.out_stride = int(out.stride());
  const auto band = device->bind({&gbuffer.planes, {}, {}, binding.tables(), &out});
  band->evaluate(binding.programs().front(), frame);
  band->finish();
  return out;
}

std::string nine_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

std::string evaluate_table(const std::string& brdf, const std::vector<std::string>& set, const std::string& device, const std::string& text) {
  Table table = parse_table(text);
  RowBand rows(table);
  const Material material = material_of(brdf, set, rows.parameters());
  const LayerFinder no_layers = [](const std::string& layer) -> RoleLayer {
    throw Error(ErrorKind::input, "--set: no layer \"" + layer + "\": a table has columns");
  };
  const Binding binding(material, {}, "stdin", no_layers, rows.reading());
  const Planes out = shade_rows(rows, binding, device);
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
