// A scan-line file of float or half channels packed by ZIP or ZIPS, without OpenEXR's encoder (openexr.com, "OpenEXR File Layout"): blocks are packed
// on all cores and go out in order.
#pragma once

#include <ImfHeader.h>
#include <ImfIO.h>
#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/write_exr.h"
#include "gbuffer/zip_block.h"

namespace relume {

class ZipOutput {
 public:
  /// Writes the header and room for the table of blocks. Both outlive it.
  ZipOutput(Imf::OStream& out, const Imf::Header& header);

  /// The next rows, top to bottom; one Source for each channel.
  void write_rows(int rows, std::span<const Source> sources);

  /// Writes the table, when every row is there.
  void finish();

 private:
  struct Piece;

  void write_table();
  void append_row(std::span<const Source* const> sources, int row, std::vector<char>& block) const;
  void fill_and_pack(Piece& piece, std::span<const Source* const> sources);
  void put(Piece& piece);

  Imf::OStream& out_;
  int width_, top_, height_, block_rows_;
  SampleType type_;
  std::size_t row_bytes_;
  std::vector<std::string> channels_;  ///< in the file's order
  std::uint64_t table_position_;
  std::vector<std::uint64_t> table_;  ///< where each block begins
  int rows_ = 0, blocks_ = 0;         ///< taken, and written, so far
  std::vector<char> begun_;           ///< rows of a block that lacks some yet
  tbb::enumerable_thread_specific<ZipPacker> packers_;
};

}  // namespace relume
