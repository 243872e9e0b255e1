// Maps in false colour side by side, with one colour bar.
#pragma once

#include <string>
#include <vector>

#include "lab/plot.h"
#include "lab/sample_table.h"

namespace relume {

/// Values over a square grid, row by row from the lowest; NaN where there is nothing.
struct Panel {
  std::string title;
  std::vector<double> values;
};

/// What the maps of a figure share.
struct PanelShape {
  int side;                  ///< samples along a side of the grid
  double low, high;          ///< where the first and last samples lie, on both axes
  double from, to;           ///< what is seen, on both axes
  std::string axes;          ///< gnuplot's commands before each map
  std::string data, over;    ///< data blocks, and what is plotted over each map: ", $rim with lines"
  bool axis_labels = false;  ///< room for them
};

/// How many samples along a side: fewer where a figure holds many maps.
int panel_side(std::size_t panels);

/// The pairs of directions of a grid's samples, row by row, and where each lies, for the table. One below the horizon has no value.
struct PanelSamples {
  std::vector<DirectionPair> pairs;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> places;
};

/// A panel for each BRDF and each of its parts; rows into `csv` if they are wanted.
std::vector<Panel> panels_of(const PlotRequest& request, const PanelSamples& samples, std::string& csv);

/// Contours at the scale's marks.
Figure panels_figure(const PlotRequest& request, const std::string& title, const std::vector<Panel>& panels, const PanelShape& shape,
                     const Scale& scale);

}  // namespace relume
