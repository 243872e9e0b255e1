// Karma: husk's render statistics, JSON in one attribute, hold the matrix world_to_ndc (research: exr-conventions A.9).
#include <nlohmann/json.hpp>
#include <string>

#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

/// Takes the numbers under "world_to_ndc", nested or not, out of JSON that may be large and need not be sound, without building a tree of it.
class MatrixFinder : public nlohmann::json_sax<nlohmann::json> {
 public:
  std::vector<double> numbers;

  bool key(string_t& name) override { return !taken() && (inside_ = name == "world_to_ndc", true); }
  bool number_integer(number_integer_t value) override { return number(double(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(double(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return !taken(); }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  bool taken() const { return numbers.size() == 16; }
  bool number(double value) {
    if (inside_) numbers.push_back(value);
    return numbers.size() <= 16;
  }
  bool inside_ = false;
};

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  const std::string json = values.text("husk:render_stats");
  if (json.find("world_to_ndc") == std::string::npos) return {};
  MatrixFinder finder;
  nlohmann::json::sax_parse(json, &finder, nlohmann::json::input_format_t::json, false);
  if (finder.numbers.size() != 16) return {};
  std::vector<Camera> cameras;
  for (const bool transposed : {false, true})
    for (Camera camera : cameras_of_projection(matrix_of(finder.numbers, transposed), display, values.pixel_aspect())) {
      camera.source = std::string("world_to_ndc in husk:render_stats") + (transposed ? ", stored transposed" : "");
      cameras.push_back(camera);
    }
  return cameras;
}

}  // namespace

extern const HeaderCamera header_camera_karma;
const HeaderCamera header_camera_karma{"karma", "world_to_ndc in husk:render_stats", "exr-conventions A.9", read};

}  // namespace relume
