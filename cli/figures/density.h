// How far flat and Gouraud interpolation are from Phong's, for finer and finer spheres.
#pragma once

#include <string>
#include <vector>

#include "cli/figures/lit_images.h"
#include "figure/figure.h"

namespace relume {

struct Density {
  int triangles;
  double edge;           ///< mean length, of a sphere of radius 1
  double gouraud, flat;  ///< root of the mean square difference to Phong interpolation, over the mean radiance
};

/// Spheres of the program's own, from an icosahedron to 81 920 triangles, seen from one place.
std::vector<Density> densities(const Lighting& lighting);

/// The exponent p of difference ~ edge^p, by least squares over the finest four.
double slope_of(const std::vector<Density>& all, double Density::*difference);

std::string csv_of(const std::vector<Density>& all);
Figure figure_of(const std::vector<Density>& all, const std::string& lobes);

}  // namespace relume
