// A measured isotropic BRDF as MERL's files hold it: Matusik et al. 2003, "A Data-Driven Reflectance Model" (merl.com/research/downloads/BRDF).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace relume {

/// f_r over Rusinkiewicz's angles: theta_h and theta_d in 0..pi/2, phi_d in 0..pi. A value is that of its bin's middle.
struct MerlTable {
  int theta_h = 90, theta_d = 90, phi_d = 180;  ///< bins; theta_h's are spaced by its square root
  std::array<std::vector<float>, 3> f;          ///< red, green, blue, 1/sr; below 0: not measured

  std::size_t entries() const { return std::size_t(theta_h) * std::size_t(theta_d) * std::size_t(phi_d); }
  std::size_t at(int h, int d, int phi) const {
    return (std::size_t(h) * std::size_t(theta_d) + std::size_t(d)) * std::size_t(phi_d) + std::size_t(phi);
  }
};

/// The angles of a bin's middle, radians.
struct MerlAngles {
  double theta_h, theta_d, phi_d;
};
MerlAngles angles_of(const MerlTable& table, int h, int d, int phi);

/// A file in the published format, or one with other numbers of bins in the same layout: 2 to 1024 along each angle, phi_d's even.
/// Error{input} for what is too short or too long, not finite, or measured nowhere.
MerlTable read_merl(const std::filesystem::path& file);
/// The same, read once as long as anybody keeps it.
std::shared_ptr<const MerlTable> shared_merl(const std::filesystem::path& file);

/// Whole or not there. Error{output}.
void write_merl(const MerlTable& table, const std::filesystem::path& file, bool overwrite);

/// What `merl` shows where no file is named: a made-up glossy plastic, so that lists, benchmarks and tests of all lobes have something to look up.
MerlTable stand_in_table(int theta_h = 90, int theta_d = 90, int phi_d = 180);

}  // namespace relume
