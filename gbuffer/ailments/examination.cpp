// Bands, rows and tallies.
#include "gbuffer/ailments/examination.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

#include "gbuffer/ailments/list.h"
#include "gbuffer/error.h"
#include "gbuffer/three_digits.h"

namespace relume {

#define RELUME_DECLARE(name) extern const Ailment ailment_##name;
RELUME_AILMENTS(RELUME_DECLARE)
#undef RELUME_DECLARE

const std::vector<Ailment>& ailments() {
#define RELUME_ENTRY(name) ailment_##name,
  static const std::vector<Ailment> list{RELUME_AILMENTS(RELUME_ENTRY)};
#undef RELUME_ENTRY
  return list;
}

std::string share_in_words(const Tally& tally) { return three_digits(100 * tally.share()) + " % of " + std::to_string(tally.judged) + " pixels"; }

namespace {

/// Pixels decoded in vain before the rest counts as lost without a try: a frame of 1080p without a single whole row takes a third of it.
constexpr std::int64_t patience = 1 << 26;

void join(std::vector<Tally>& to, const std::vector<Tally>& from) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k].join(from[k]);
}

/// The same tallies before the first pixel: marks stay.
std::vector<Tally> emptied(std::vector<Tally> tallies) {
  for (Tally& tally : tallies) {
    Tally empty;
    empty.marks = tally.marks;
    empty.marked = tally.marked;
    empty.mark = tally.mark;
    tally = empty;
  }
  return tallies;
}

}  // namespace

Examination::Examination(const Patient& patient) : patient_(patient) {
  for (const Ailment& ailment : ailments()) {
    const std::size_t known = findings_.size();
    ailment.examine(patient, checks_, findings_);
    sign(ailment, known);
    whose_.resize(checks_.size(), &ailment);
  }
  for (const Check& check : checks_) {
    first_.push_back(tallies_.size());
    tallies_.resize(tallies_.size() + std::size_t(check.tallies));
    roles_.insert(check.roles.begin(), check.roles.end());
  }
  for (std::size_t k = 0; k < tallies_.size(); ++k) tallies_[k].mark = std::uint8_t(std::min<std::size_t>(k + 1, 255));
}

void Examination::mark_in(std::uint8_t* plane, std::uint8_t mark) {
  for (Tally& tally : tallies_)
    if (tally.mark == mark) tally.marks = plane, tally.marked = patient_.reading.data_window;
}

void Examination::sign(const Ailment& ailment, std::size_t from) {
  for (std::size_t k = from; k < findings_.size(); ++k) findings_[k].ailment = ailment.name;
}

std::size_t Examination::channels() const {
  std::size_t count = 1;
  for (const std::string& role : roles_)
    if (patient_.has(role)) count += patient_.layer(role).channels.size();
  return count;
}

void Examination::look() {
  const Window& all = patient_.reading.data_window;
  if (checks_.empty() || all.empty()) return;
  constexpr std::int64_t budget = 256 << 20, block = 256;  // bytes: a whole frame of 1080p; rows: a multiple of every codec's block
  const std::int64_t row_bytes = std::int64_t(sizeof(float)) * all.width() * std::int64_t(channels());
  const int rows = int(std::clamp<std::int64_t>(budget / row_bytes / block * block, 32, all.height()));
  for (std::int64_t top = all.min_y; top < all.max_y; top += rows)
    look_at({all.min_x, int(top), all.max_x, int(std::min<std::int64_t>(top + rows, all.max_y))}, 1);
}

/// `margin`: rows of the neighbourhood to hold as well.
void Examination::look_at(const Window& window, int margin) {
  const Window& all = patient_.reading.data_window;
  const Window held{window.min_x, std::max(window.min_y - margin, all.min_y), window.max_x, std::min(window.max_y + margin, all.max_y)};
  if (lost_ >= patience) return unreadable_.add_all(window);
  try {
    const DecodedRows band(patient_.file, patient_.reading, {roles_.begin(), roles_.end()}, held);
    join(tallies_, looked_at(band, window));
  } catch (const Error& error) {
    if (error.kind != ErrorKind::input) throw;
    lose(window, error.what());
  }
}

/// Halves a band that cannot be decoded until the rows that cannot are found.
void Examination::lose(const Window& window, const std::string& fault) {
  fault_ = fault;
  lost_ += window.pixels();
  if (window.height() > 1 && lost_ < patience) {
    const int middle = window.min_y + window.height() / 2;
    look_at({window.min_x, window.min_y, window.max_x, middle}, 0);
    look_at({window.min_x, middle, window.max_x, window.max_y}, 0);
    return;
  }
  unreadable_.add_all(window);
}

Examination::Tallies Examination::looked_at(const DecodedRows& band, const Window& window) const {
  const LayerFrame frame(patient_.reading);
  const auto look = [&](const tbb::blocked_range<int>& rows, Tallies found) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      const Row row(band, patient_.reading, frame, y);
      for (std::size_t k = 0; k < checks_.size(); ++k) checks_[k].look(row, std::span(found).subspan(first_[k], std::size_t(checks_[k].tallies)));
    }
    return found;
  };
  const auto joined = [](Tallies a, const Tallies& b) {
    join(a, b);
    return a;
  };
  constexpr std::size_t grain = 8;  // rows: a row of 1080p is a tenth of a millisecond
  return tbb::parallel_reduce(tbb::blocked_range<int>(window.min_y, window.max_y, grain), emptied(tallies_), look, joined);
}

void Examination::conclude_unreadable() {
  if (unreadable_.pixels == 0) return;
  const std::int64_t rows = unreadable_.pixels / unreadable_.box.width();
  findings_.push_back({"incomplete", Severity::defect, "", unreadable_,
                       (lost_ < patience ? "" : "up to ") + std::to_string(rows) + " rows cannot be decoded: " + fault_,
                       "relume shade refuses the file; other programs show black or garbage there",
                       "render or copy the file again; --crop X0,Y0,X1,Y1 leaves the rows out"});
}

std::vector<Finding> Examination::conclude() {
  for (std::size_t k = 0; k < checks_.size(); ++k) {
    const std::size_t known = findings_.size();
    checks_[k].conclude(std::span(tallies_).subspan(first_[k], std::size_t(checks_[k].tallies)), findings_);
    sign(*whose_[k], known);
  }
  conclude_unreadable();
  return std::move(findings_);
}

}  // namespace relume
