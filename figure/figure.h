// A figure: gnuplot's data and commands, drawn as SVG, PNG or PDF.
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace relume {

struct Figure {
  std::string data;               ///< data blocks: "$name << END ... END"
  std::string commands;           ///< titles, axes and the plot itself
  int width = 900, height = 560;  ///< pixels of the PNG; SVG and PDF have the same shape
  bool markup = false;            ///< whether texts are gnuplot's enhanced ones, where _ and ^ lower and raise
};

/// Colours that the colour-blind tell apart, fonts, borders: what every figure begins with.
extern const char* const figure_look;

/// Its colours, Okabe and Ito's, as gnuplot's rgb has them: linetypes 1 to 6.
inline constexpr std::array figure_colours{"0072B2", "D55E00", "009E73", "CC79A7", "E69F00", "56B4E9"};

/// gnuplot's `set terminal` for a file of this name. Error{input} unless it ends in .svg, .png or .pdf.
std::string terminal_for(const std::filesystem::path& file, const Figure& figure);

/// Draws it to a file that is whole or not there. Error{input} for another ending, Error{output} where gnuplot is not here or refuses.
void draw(const Figure& figure, const std::filesystem::path& file, bool overwrite);

/// A text of gnuplot's in quotes; a figure without markup shows it as it is.
std::string quoted(const std::string& text);

}  // namespace relume
