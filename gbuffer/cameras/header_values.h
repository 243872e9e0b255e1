// A header's attributes as numbers, whatever type a writer gave them: int, float, double, vectors, matrices, or text ("[1.0, 0.0, ...]").
#pragma once

#include <ImfHeader.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relume {

class HeaderValues {
 public:
  /// Keeps a reference.
  explicit HeaderValues(const Imf::Header& header);

  /// Names are compared without regard to case, and without the "exr/" that Nuke puts before what it read from a file.
  bool has(const std::string& name) const { return find(name) != nullptr; }
  std::optional<double> number(const std::string& name) const;
  /// Finite numbers in storage order; empty unless there are exactly `count`.
  std::optional<std::vector<double>> numbers(const std::string& name, std::size_t count) const;
  /// Empty where there is no such text.
  std::string text(const std::string& name) const;
  /// Names, in lower case, that begin and end so.
  std::vector<std::string> names(const std::string& begin, const std::string& end) const;

  const Imf::Header& header() const { return header_; }
  double pixel_aspect() const;

 private:
  const Imf::Attribute* find(const std::string& name) const;

  const Imf::Header& header_;
  std::map<std::string, const Imf::Attribute*> attributes_;  ///< by name in lower case
};

}  // namespace relume
