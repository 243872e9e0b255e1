// Laws of the factors of microfacet lobes: distributions of normals, shadowing and masking, Fresnel.
#pragma once

#include "lab/laws/list.h"

namespace relume {

/// The factors with settings, as Examined::terms has them.
using TermsWith = std::function<TermsOf(const Setting&)>;

/// How far the integral of D n.h is from 1, at its worst width: the facets' areas, projected, are the surface.
Deviation distribution_normalised(const TermsWith& terms);

/// How far D differs between pairs of directions that have the same h, or is negative.
Deviation distribution_of_facets(const TermsWith& terms);

/// The weak white furnace (Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 20, for D and G1 in place of the lobe): how far the
/// visible facets' projected area, the integral of D G1(v) max(v.h, 0)/n.v, is from 1. G1(v) is G with l = n, so of Smith's forms alone.
Deviation weak_furnace(const TermsWith& terms);

/// How far G is outside 0..1, above a part of it (G1 of l or v for Smith's; 2 n.h n.v/v.h and its like for V-grooves), or from 1 straight on.
Deviation shadowing_bounded(const TermsWith& terms, bool smith);

/// How far F is outside 0..1, falls from normal to grazing incidence (but conductors' and dielectrics' beyond an ior of 3.73, which
/// may: near Brewster's angle), or is at either end from what
/// the term's parameters say: ((ior-1)/(ior+1))^2 and 1; f0 and f90; ((eta-1)^2+k^2)/((eta+1)^2+k^2) and 1; ks.
Deviation fresnel_bounded(const std::string& fresnel, const TermsWith& terms);

}  // namespace relume
