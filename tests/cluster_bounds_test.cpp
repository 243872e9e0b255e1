// What bounds a cluster of lights holds for every pixel: its least light, and how far its stand-ins are from it, for every lobe's own kernels.
#include "host/cluster_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/light_lists.h"
#include "tests/unranged_lights.h"

namespace relume {
namespace {

/// Both halves, and which of the records are met by every pixel.
std::vector<float> halves_under(UnrangedScene& scene, std::span<const int> records) {
  Frame frame = scene.frame;
  frame.diffuse = 3, frame.specular = 6, frame.lists = 1;
  const int blocks = (frame.pixels + RELUME_LISTED_PIXELS - 1) / RELUME_LISTED_PIXELS;
  std::vector<int> lists{0};
  for (int b = 0; b < blocks; ++b) lists.insert(lists.end(), {1 + 2 * blocks, 1 + 2 * blocks + int(records.size())});
  lists.insert(lists.end(), records.begin(), records.end());
  return shaded(scene, frame, lists);
}

std::vector<int> numbers_of(const StandIns& made) {
  std::vector<int> numbers(std::size_t(made.count));
  std::iota(numbers.begin(), numbers.end(), made.first);
  return numbers;
}

/// What a half of the BRDF is multiplied by to compare with its bounds, for a pixel.
double factor_at(const UnrangedScene& scene, int half, int c, int i) {
  const LobeFactor factor = half == half_specular ? specular_factor(scene.programs[0]) : diffuse_factor(scene.programs[0]);
  if (factor.field < 0) return 1;
  const Field& field = scene.frame.field[factor.field];
  return factor.scale * scene.planes.data()[field.offset + c * field.component_step + i * field.step];
}

/// Of one cluster, on the patches of some single blocks: both halves of every pixel.
void expect_bounds(UnrangedScene& scene, const LightTree& tree, int number) {
  const LightCluster& cluster = tree.clusters()[std::size_t(number)];
  const PixelCells cells(scene.planes, scene.frame, width);
  const std::vector<float> exact = halves_under(scene, tree.order().subspan(std::size_t(cluster.begin), std::size_t(cluster.end - cluster.begin)));
  const std::vector<float> one = halves_under(scene, numbers_of(cluster.one)), four = halves_under(scene, numbers_of(cluster.four));
  for (int block = 0; block < scene.frame.pixels / PixelCells::block; block += 7) {
    std::vector<PixelPatch> patches;
    add_patches(cells, 0, block, 1, 2, patches);
    if (patches.size() != 1) continue;
    ClusterBounds bounds;
    bound_clusters(scene.programs[0], patches[0], scene.tables.data(), tree.clusters(), std::span(&number, 1), bounds);
    for (int at = 0; at < 6 * PixelCells::block; ++at) {
      const int i = block * PixelCells::block + at / 6, half = at / 3 % 2, c = at % 3;
      if (scene.planes.plane(6)[i] < 0) continue;
      const std::size_t value = std::size_t(3 + 3 * half + c) * scene.out.stride() + std::size_t(i);
      const double factor = factor_at(scene, half, c, i), rounding = 1e-4 * exact[value];
      ASSERT_GE(exact[value] + rounding, factor * bounds.low[half][c][0]) << "cluster " << number << ", pixel " << i;
      ASSERT_TRUE(cluster.one.count == 0 || std::fabs(exact[value] - one[value]) <= factor * bounds.one[half][c][0] + rounding) << number << " " << i;
      ASSERT_TRUE(cluster.four.count == 0 || std::fabs(exact[value] - four[value]) <= factor * bounds.four[half][c][0] + rounding)
          << number << " " << i;
    }
  }
}

class EveryLobe : public testing::TestWithParam<Case> {};

TEST_P(EveryLobe, BoundsHoldForEachCluster) {
  UnrangedScene scene = make_scene(*GetParam().look, *GetParam().rig, 300);
  const LightTree tree(scene.lights, scene.begin);
  for (int number = 0; number < int(tree.clusters().size()); number += 3) expect_bounds(scene, tree, number);
}

INSTANTIATE_TEST_SUITE_P(ClusterBounds, EveryLobe, testing::ValuesIn(every_case()),
                         [](const auto& info) { return std::string(info.param.look->name) + "_" + info.param.rig->name; });

}  // namespace
}  // namespace relume
