// bound_clusters: the compilation that this processor runs best; and which lobes are proportional to what.
#include "host/cluster_bounds.h"

#include <numbers>

namespace relume {

using BoundClusters = void (*)(const Choice&, const PixelPatch&, const float*, std::span<const LightCluster>, std::span<const int>, ClusterBounds&);

#define RELUME_BOUNDS(processor)                                                                                                            \
  namespace processor {                                                                                                                     \
  void bound_clusters(const Choice&, const PixelPatch&, const float*, std::span<const LightCluster>, std::span<const int>, ClusterBounds&); \
  }
RELUME_BOUNDS(portable)
RELUME_BOUNDS(avx2)
RELUME_BOUNDS(avx512)

LobeFactor diffuse_factor(const Choice& choice) {
  constexpr float inverse_pi = 1 / std::numbers::pi_v<float>;
  switch (choice.diffuse) {
    case DIFFUSE_lambert:
      return {FIELD_albedo, inverse_pi};  // its bounds are of n.l alone
    case DIFFUSE_lambert_original:
      return {FIELD_kd, 1};
    case DIFFUSE_oren_nayar:
    case DIFFUSE_burley:
    case DIFFUSE_gltf:
      return {FIELD_albedo, 1};
    default:
      return {};
  }
}

LobeFactor specular_factor(const Choice& choice) {
  switch (choice.specular) {
    case SPECULAR_phong_original:
    case SPECULAR_phong:
    case SPECULAR_blinn_phong_original:
    case SPECULAR_blinn_phong:
    case SPECULAR_blinn_phong_exact:
      return {FIELD_ks, 1};
    case SPECULAR_cycles_glossy:
      return {FIELD_glossy_albedo, 1};
    case SPECULAR_cook_torrance:
    case SPECULAR_beckmann:
    case SPECULAR_ggx:
      return choice.fresnel == FRESNEL_none ? LobeFactor{FIELD_ks, 1} : LobeFactor{};
    default:
      return {};
  }
}

void bound_clusters(const Choice& choice, const PixelPatch& patch, const float* tables, std::span<const LightCluster> clusters,
                    std::span<const int> which, ClusterBounds& bounds) {
  static const BoundClusters best = [] {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return avx512::bound_clusters;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::bound_clusters;
#endif
    return portable::bound_clusters;
  }();
  best(choice, patch, tables, clusters, which, bounds);
}

}  // namespace relume
