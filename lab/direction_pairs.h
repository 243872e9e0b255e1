// Pairs of directions that try a lobe: anywhere, grazing, mirrored, and the ends.
#pragma once

#include <vector>

#include "lab/brdf.h"

namespace relume {

/// Cosines down to 1e-8; the same every time.
std::vector<DirectionPair> direction_pairs();

/// The unit vector of this cosine and azimuth.
glm::dvec3 direction_at(double cosine, double azimuth);

/// l = v = h at this cosine: what a facet that faces the viewer shows.
DirectionPair facing(double cosine);

/// l in the mirror direction of v.
DirectionPair mirrored(double cosine);

/// "view 80, light 30 degrees".
std::string text_of(const DirectionPair& pair);

}  // namespace relume
