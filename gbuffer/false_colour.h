// Layers as pictures to look at: directions, places, depths, ids and numbers in colours that colour-blind people can tell apart too.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/picture.h"
#include "gbuffer/reading.h"

namespace relume {

/// One layer of a file, every `step`-th pixel of the data window.
struct View {
  std::string name;   ///< plain letters, for a file's name: "normal"
  std::string label;  ///< "depth: Z, 8.1 dark .. 3.2, log"
  CodedPicture picture;
};

/// What longer side pictures are kept to: pixels are left out of larger frames.
inline constexpr int longest_view = 2048;
int view_step(const Window& data);

/// A view of every role that the reading has. NaN and infinities are vermillion.
std::vector<View> false_colour_views(const ExrFile& file, const Reading& reading);

/// Colours of single pixels, as the views have them: a unit vector, a cosine (viridis over 0..1, below 0 vermillion), and where nothing is shown.
using RgbCode = std::array<std::uint8_t, 3>;
RgbCode direction_colour(double x, double y, double z);
RgbCode cosine_colour(double cosine);
inline constexpr RgbCode no_surface_colour{40, 40, 40};

/// Marked pixels over a dimmed view of the same window: `defect[mark]` vermillion, others sky blue, 0 unmarked.
View marked_view(const View& under, const Window& data, const std::vector<std::uint8_t>& marks, const std::vector<bool>& defect);

}  // namespace relume
