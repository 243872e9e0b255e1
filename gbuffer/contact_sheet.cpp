// The layout of a contact sheet; OpenImageIO scales and letters it.
#include "gbuffer/contact_sheet.h"

#include <algorithm>

#include "gbuffer/picture_module.h"

namespace relume {
namespace {

SheetShape shape_of(const std::vector<View>& views) {
  constexpr int widest = 520, gap = 12, label_height = 24;  // three abreast fit a screen
  const CodedPicture& first = views.front().picture;
  // Small frames grow by whole steps: every pixel is to be seen.
  const double scale = first.width >= widest ? double(widest) / first.width : double(std::max(1, widest / first.width));
  const int width = std::max(1, int(first.width * scale)), height = std::clamp(int(first.height * scale), 1, 4096);
  const int columns = std::clamp(1600 / (width + gap), 1, std::max(1, int(views.size())));
  return {columns, width, height, label_height, gap};
}

}  // namespace

CodedPicture contact_sheet(const std::vector<View>& views) {
  const SheetShape shape = shape_of(views);
  const int rows = (int(views.size()) + shape.columns - 1) / shape.columns;
  CodedPicture sheet{
      shape.columns * (shape.tile_width + shape.gap) + shape.gap, rows * (shape.tile_height + shape.label_height + shape.gap) + shape.gap, 3, {}};
  sheet.codes.assign(std::size_t(sheet.width) * std::size_t(sheet.height) * 3, 16);
  std::vector<SheetTile> tiles;
  for (const View& view : views) tiles.push_back({view.label.c_str(), view.picture.codes.data(), view.picture.width, view.picture.height});
  compose_sheet(tiles, shape, sheet);
  return sheet;
}

}  // namespace relume
