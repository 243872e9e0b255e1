// What a group of measurements is made to answer: how much faster than, how many milliseconds, what share of the peak; and what was asked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/subject.h"

namespace relume::bench {

enum class Measure {
  rate_over,     ///< the subject's rate over the other's: pixel*lights a second where both have them, else goes a second
  time_over,     ///< the subject's time over the other's
  milliseconds,  ///< the subject's time
  peak_share     ///< useful flop/s over the device's measured peak
};

struct Claim {
  Measure measure;
  std::string subject, other;  ///< names; `other` empty where there is none
  std::string sentence;        ///< between the subject's name and the number: "over plain C++ on the same threads"
  double goal = 0;             ///< at least, for rates and shares; at most, for times; 0: none
};

struct Weighed {
  Claim claim;
  double median, low, high;  ///< low and high: the quartiles over the rounds
  double processor;  ///< the median from processor time over threads: what it would be if nobody else used the machine, and all threads were busy

  bool met() const;
};

/// Round by round, so that what disturbed a round disturbed both. Empty where a subject was not measured.
std::optional<Weighed> weigh(const Claim& claim, const std::vector<Measurement>& measured);

}  // namespace relume::bench
