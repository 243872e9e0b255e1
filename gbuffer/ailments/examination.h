// One pass over a file's pixels: bands of rows, decoded once, through the checks of all ailments on all cores.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "gbuffer/ailments/ailment.h"

namespace relume {

class Examination {
 public:
  /// Asks every ailment what header and reading tell, and what to look for. The patient outlives the examination.
  explicit Examination(const Patient& patient);

  /// From now on the pixels of a tally (by its `mark`) are set to that mark in a plane over the reading's data window.
  void mark_in(std::uint8_t* plane, std::uint8_t mark);

  /// Looks at every pixel. Rows that cannot be decoded are counted.
  void look();

  /// What was found, defects and hints in the order of the list.
  std::vector<Finding> conclude();

 private:
  using Tallies = std::vector<Tally>;

  void sign(const Ailment& ailment, std::size_t from);
  std::size_t channels() const;
  void look_at(const Window& window, int margin);
  void lose(const Window& window, const std::string& fault);
  Tallies looked_at(const DecodedRows& band, const Window& window) const;
  void conclude_unreadable();

  const Patient& patient_;
  std::vector<Check> checks_;
  std::vector<const Ailment*> whose_;  ///< of each check
  std::vector<std::size_t> first_;     ///< tally of each check
  Tallies tallies_;
  std::set<std::string> roles_{"normal", "position", "depth", "coverage", "ids"};
  Tally unreadable_;
  std::int64_t lost_ = 0;  ///< pixels of the bands that were tried in vain
  std::string fault_;      ///< why
  std::vector<Finding> findings_;
};

}  // namespace relume
