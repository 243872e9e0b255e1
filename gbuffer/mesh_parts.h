// The parts of a baked G-buffer beside its pixels: the mesh's vertices and facets, as lists of samples with the same channels.
#pragma once

#include <string>

#include "gbuffer/reading.h"

namespace relume {

inline const std::string vertices_part = "vertices", facets_part = "facets";
/// Of pixels: the number of the facet that each shows, and the weights of its second and third vertex.
inline const std::string facet_channel = "triangle", second_weight_channel = "barycentric.U", third_weight_channel = "barycentric.V";
/// Of facets: the numbers of their three vertices.
inline const std::string facet_vertex_channels[] = {"vertex0", "vertex1", "vertex2"};

/// Lists, not pictures of the scene.
inline bool is_mesh_part(const Part& part) { return part.name == vertices_part || part.name == facets_part; }

/// The part of this name; Error{input} that says who writes one, where there is none.
const Part& mesh_part(const ExrFile& file, const std::string& name);

/// The reading of the pixels, for a list: the same roles from its channels of the same names. Error{input} where it lacks one.
Reading reading_of_part(const Reading& pixels, const ExrFile& file, const Part& part);

}  // namespace relume
