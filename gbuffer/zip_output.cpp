// ZipOutput: rows are put into blocks, blocks packed in parallel and written in order.
#include "gbuffer/zip_output.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "gbuffer/half_floats.h"

namespace relume {
namespace {

bool is_long(const char* name) { return std::strlen(name) > 31; }

/// Readers older than OpenEXR 1.7 must be told of names of more than 31 letters.
bool has_long_names(const Imf::Header& header) {
  for (auto i = header.begin(); i != header.end(); ++i)
    if (is_long(i.name()) || is_long(i.attribute().typeName())) return true;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
    if (is_long(i.name())) return true;
  return false;
}

template <class Value>
void write_value(Imf::OStream& out, const Value& value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

void write_beginning(Imf::OStream& out, const Imf::Header& header) {
  constexpr std::uint32_t magic = 20000630, version = 2, long_names = 0x400;
  header.sanityCheck();
  write_value(out, magic);
  write_value(out, version | (has_long_names(header) ? long_names : 0));
  header.writeTo(out);
}

}  // namespace

/// Rows of one call that go into one block.
struct ZipOutput::Piece {
  int first = 0, count = 0;  ///< of the rows of the call
  std::vector<char> block;   ///< rows of earlier calls, then these; packed in the end
  bool full = false;
};

ZipOutput::ZipOutput(Imf::OStream& out, const Imf::Header& header) : out_(out) {
  const Imath::Box2i& window = header.dataWindow();
  width_ = window.max.x - window.min.x + 1;
  height_ = window.max.y - window.min.y + 1;
  top_ = window.min.y;
  block_rows_ = header.compression() == Imf::ZIPS_COMPRESSION ? 1 : 16;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) channels_.emplace_back(i.name());
  type_ = header.channels().begin().channel().type == Imf::HALF ? SampleType::half_float : SampleType::float32;
  row_bytes_ = channels_.size() * std::size_t(width_) * (type_ == SampleType::half_float ? sizeof(half) : sizeof(float));
  table_.resize(std::size_t((height_ + block_rows_ - 1) / block_rows_));  // zeros: a file that was never finished
  write_beginning(out_, header);
  table_position_ = out_.tellp();
  write_table();
}

void ZipOutput::write_table() {
  for (const std::uint64_t position : table_) write_value(out_, position);
}

void ZipOutput::finish() {
  out_.seekp(table_position_);
  write_table();
}

void ZipOutput::append_row(std::span<const Source* const> sources, int row, std::vector<char>& block) const {
  const std::size_t bytes = row_bytes_ / channels_.size();
  std::size_t at = block.size();
  block.resize(at + row_bytes_);
  std::vector<float> gathered;
  for (const Source* const source : sources) {
    const float* const floats = source->row(row, width_, gathered);
    if (type_ == SampleType::half_float)
      halves_of(floats, reinterpret_cast<half*>(block.data() + at), std::size_t(width_));
    else
      std::memcpy(block.data() + at, floats, bytes);
    at += bytes;
  }
}

void ZipOutput::fill_and_pack(Piece& piece, std::span<const Source* const> sources) {
  piece.block.reserve(row_bytes_ * std::size_t(block_rows_));
  for (int row = piece.first; row < piece.first + piece.count; ++row) append_row(sources, row, piece.block);
  if (!piece.full) return;
  const std::span<const char> packed = packers_.local().pack(piece.block);
  if (packed.data() != piece.block.data()) piece.block.assign(packed.begin(), packed.end());
}

void ZipOutput::put(Piece& piece) {
  if (!piece.full) {
    begun_ = std::move(piece.block);
    return;
  }
  table_[std::size_t(blocks_)] = out_.tellp();
  write_value(out_, std::int32_t(top_ + blocks_++ * block_rows_));
  write_value(out_, std::int32_t(piece.block.size()));
  out_.write(piece.block.data(), int(piece.block.size()));
}

void ZipOutput::write_rows(int rows, std::span<const Source> sources) {
  std::vector<const Source*> in_order;
  for (const std::string& channel : channels_)
    in_order.push_back(&*std::find_if(sources.begin(), sources.end(), [&](const Source& s) { return s.channel == channel; }));
  int next = 0;
  const auto begin_piece = [&](tbb::flow_control& flow) {
    Piece piece;
    if (next == rows) {  // and what is begun by now is for the next call
      flow.stop();
      return piece;
    }
    piece.block = std::exchange(begun_, {});
    const int there = int(piece.block.size() / row_bytes_);
    piece.first = next;
    piece.count = std::min(block_rows_ - there, rows - next);
    next += piece.count;
    piece.full = there + piece.count == block_rows_ || rows_ + next == height_;
    return piece;
  };
  const auto pack_piece = [&](Piece piece) {
    fill_and_pack(piece, in_order);
    return piece;
  };
  const std::size_t in_flight = 2 * tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::parallel_pipeline(in_flight, tbb::make_filter<void, Piece>(tbb::filter_mode::serial_in_order, begin_piece) &
                                        tbb::make_filter<Piece, Piece>(tbb::filter_mode::parallel, pack_piece) &
                                        tbb::make_filter<Piece, void>(tbb::filter_mode::serial_in_order, [&](Piece piece) { put(piece); }));
  rows_ += rows;
}

}  // namespace relume
