// MERL's files: three counts of 32 bits, then red, green and blue as planes of doubles, little-endian.
#include "host/merl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <numbers>
#include <string>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"

namespace relume {
namespace {

static_assert(std::endian::native == std::endian::little, "the files are read as they lie");

/// What a stored number is multiplied by, per channel: BRDFRead.cpp, which comes with the files.
constexpr std::array<double, 3> scales{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

constexpr int most_bins = 1024;  // 24 GB of doubles, were all three so many: no count beyond is meant

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::input,
              printable(file.string()) + ": " + what + " (a MERL table is three 32-bit counts, 90 90 180, then 3 x 1458000 doubles)");
}

std::ifstream opened(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) throw Error(ErrorKind::input, printable(file.string()) + ": no such file");
  if (!std::filesystem::is_regular_file(file, failed)) throw Error(ErrorKind::input, printable(file.string()) + ": is no regular file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(ErrorKind::input, printable(file.string()) + ": cannot be read");
  return in;
}

MerlTable read_header(std::ifstream& in, const std::filesystem::path& file) {
  std::array<std::int32_t, 3> counts{};
  if (!in.read(reinterpret_cast<char*>(counts.data()), sizeof counts)) refuse(file, "is too short for a MERL table's header");
  MerlTable table{counts[0], counts[1], counts[2], {}};
  for (const int count : counts)
    if (count < 2 || count > most_bins)
      refuse(file,
             "is no MERL table: its counts are " + std::to_string(counts[0]) + " " + std::to_string(counts[1]) + " " + std::to_string(counts[2]));
  if (table.phi_d % 2) refuse(file, "has " + std::to_string(table.phi_d) + " bins of phi_d, which must be even: the middle of 0..pi divides them");
  const std::uintmax_t wanted = sizeof counts + 3 * sizeof(double) * table.entries(), bytes = std::filesystem::file_size(file);
  if (bytes != wanted) refuse(file, "has " + std::to_string(bytes) + " bytes where its counts need " + std::to_string(wanted));
  return table;
}

}  // namespace

MerlAngles angles_of(const MerlTable& table, int h, int d, int phi) {
  const double share_h = (h + 0.5) / table.theta_h, right = std::numbers::pi / 2;
  return {share_h * share_h * right, (d + 0.5) / table.theta_d * right, (phi + 0.5) / table.phi_d * 2 * right};
}

MerlTable read_merl(const std::filesystem::path& file) {
  std::ifstream in = opened(file);
  MerlTable table = read_header(in, file);
  std::vector<double> plane(table.entries());
  bool measured = false;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!in.read(reinterpret_cast<char*>(plane.data()), std::streamsize(plane.size() * sizeof(double)))) refuse(file, "cannot be read to its end");
    table.f[c].resize(plane.size());
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const double value = plane[i] * scales[c];
      // Beyond float's range is as little a reflectance as NaN is.
      if (!(std::fabs(value) <= 3e38)) refuse(file, "is no MERL table: number " + std::to_string(c * plane.size() + i) + " is not finite");
      table.f[c][i] = float(value);
      measured = measured || value >= 0;
    }
  }
  if (!measured) refuse(file, "holds no measurement: every number is negative");
  return table;
}

std::shared_ptr<const MerlTable> shared_merl(const std::filesystem::path& file) {
  static std::mutex mutex;
  static std::map<std::filesystem::path, std::weak_ptr<const MerlTable>> tables;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const MerlTable>& kept = tables[file];
  std::shared_ptr<const MerlTable> table = kept.lock();
  if (!table) kept = table = std::make_shared<const MerlTable>(read_merl(file));
  return table;
}

void write_merl(const MerlTable& table, const std::filesystem::path& file, bool overwrite) {
  WholeFile whole(file, overwrite);
  const std::array<std::int32_t, 3> counts{table.theta_h, table.theta_d, table.phi_d};
  whole.write(counts.data(), sizeof counts);
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> plane;
    plane.reserve(table.f[c].size());
    for (const float value : table.f[c]) plane.push_back(value < 0 ? -1.0 : double(value) / scales[c]);
    whole.write(plane.data(), plane.size() * sizeof(double));
  }
  whole.commit();
}

MerlTable stand_in_table(int theta_h, int theta_d, int phi_d) {
  MerlTable table{theta_h, theta_d, phi_d, {}};
  constexpr std::array<double, 3> base{0.12, 0.06, 0.03};  // f_r of the body, an orange's
  for (std::size_t c = 0; c < 3; ++c) table.f[c].reserve(table.entries());
  for (int h = 0; h < theta_h; ++h)
    for (int d = 0; d < theta_d; ++d) {
      const MerlAngles angles = angles_of(table, h, d, 0);
      const double highlight = 0.6 * std::pow(std::cos(angles.theta_h), 64) * (0.2 + 0.8 * std::pow(1 - std::cos(angles.theta_d), 5));
      for (std::size_t c = 0; c < 3; ++c) table.f[c].insert(table.f[c].end(), std::size_t(phi_d), float(base[c] + highlight));
    }
  return table;
}

}  // namespace relume
