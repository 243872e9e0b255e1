// What a cluster of lights can do to a patch of pixels: the least that it lights it, and how far its stand-ins can be from it.
//
// For a light at x the radiance of a pixel at p is I K(x), K(x) = f(n.l, l.v)/|x-p|^2 with f = f_r n.l. Stand-ins have the lights' moments of degree
// 0 and 1, so that of Taylor's series about their centre c what follows the first derivative is the error (Taylor's theorem with Lagrange's
// remainder):
//   |error| <= 1/2 max|K''| sum I |x-c|^2  over lights and stand-ins, the maximum over the ball that holds them;
// for Lambert, whose K = -n.grad(1/|x-p|) is harmonic and whose m-th derivatives are at most (m+1)!/d^(m+2), the trace of the second moments has no
// effect and the series goes one further:
//   |error| <= 1/2 |K''|_F |difference of the moments without their trace|_F + 4 sum I |x-c|^3/d^5.
// Where the horizon runs through the ball, or a lobe has a kink there, it is the range of K alone: |error| <= I (max K - min K).
#pragma once

#include <span>

#include "host/light_tree.h"
#include "host/pixel_patch.h"

namespace relume {

/// Clusters that are bounded at a time.
constexpr int bounded_at_once = 16;

enum Half { half_diffuse, half_specular, halves };

/// Of clusters side by side, for each half of the BRDF and each channel. The diffuse half is told for a factor of 1 (see PatchLobes).
struct ClusterBounds {
  float low[halves][3][bounded_at_once];   ///< of the radiance by the lights
  float one[halves][3][bounded_at_once];   ///< error of StandIns one
  float four[halves][3][bounded_at_once];  ///< error of StandIns four
  float high[bounded_at_once];             ///< 0 where the lights are behind every pixel
};

/// A parameter that a lobe is proportional to, taken out of it: the bound holds for each of its values. -1: none.
struct LobeFactor {
  int field = -1;
  float scale = 1;  ///< what the kernels multiply it by
};
LobeFactor diffuse_factor(const Choice& choice);
LobeFactor specular_factor(const Choice& choice);

/// `which`: bounded_at_once at most.
void bound_clusters(const Choice& choice, const PixelPatch& patch, const float* tables, std::span<const LightCluster> clusters,
                    std::span<const int> which, ClusterBounds& bounds);

}  // namespace relume
