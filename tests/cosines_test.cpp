// The cosines and the small quantities beside them, from directions as files store them; and which way a normal is taken to point.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/reflectance.h"

namespace relume {
namespace {

kernel::real3 vector_of(const Direction& d) { return kernel::real3_of(static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)); }
Direction as_stored(const kernel::real3& v) { return {v.x, v.y, v.z}; }

// The small quantities must be as good as the directions, which hold 6e-8: an angle of 1e-3 between n and h is then known to 1e-4 of itself.
TEST(Cosines, SmallAnglesDoNotCancel) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const auto unit = [&](double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    return Direction{x / length, y / length, z / length};
  };
  for (int i = 0; i < 10000; ++i) {
    const Direction v = unit(normal(random), normal(random), normal(random));
    const double spread = std::pow(10.0, -1 - 2.5 * (i % 100) / 100);
    const Direction n = unit(v.x + 0.5 * normal(random), v.y + 0.5 * normal(random), v.z + 0.5 * normal(random));
    if (dot(n, v) < 0.1) continue;
    const double to = 2 * dot(n, v);
    const Direction l =
        unit(to * n.x - v.x + spread * normal(random), to * n.y - v.y + spread * normal(random), to * n.z - v.z + spread * normal(random));
    if (dot(n, l) < 0.1) continue;
    const kernel::Cosines got = kernel::cosines_of(vector_of(n), vector_of(l), vector_of(v));
    const Direction ns = as_stored(vector_of(n)), ls = as_stored(vector_of(l)), vs = as_stored(vector_of(v));
    const PreciseCosines wanted = precise_cosines(dot(n, l), dot(n, v), dot(l, v));
    EXPECT_NEAR(got.n_l, dot(ns, ls), 2e-7);
    EXPECT_NEAR(got.n_v, dot(ns, vs), 2e-7);
    EXPECT_NEAR(got.l_v, dot(ls, vs), 2e-7);
    EXPECT_NEAR(got.sum2, wanted.sum2, 1e-6 * wanted.sum2 + 1e-6 * std::sqrt(wanted.sum2));
    EXPECT_NEAR(std::sqrt(got.across2), std::sqrt(wanted.across2), 4e-7);
    EXPECT_NEAR(std::sqrt(got.tan2_h), std::sqrt(wanted.tan2_h), 1e-6 / std::sqrt(wanted.along2));
    EXPECT_NEAR(std::sqrt(got.chord2), std::sqrt(wanted.chord2), 4e-7);
    EXPECT_NEAR(got.along2, wanted.along2, 2e-6);
    EXPECT_NEAR(got.r_l, 2 * dot(n, l) * dot(n, v) - dot(l, v), 1e-6);
    EXPECT_NEAR(kernel::v_h(got), std::sqrt(wanted.sum2) / 2, 5e-7);
    EXPECT_NEAR(kernel::n_h_squared(got), wanted.along2 / wanted.sum2, 1e-6);
  }
}

TEST(Cosines, WhereLightAndViewerAreOppositeTheyStayFinite) {
  const kernel::real3 up = kernel::real3_of(0.0f, 0.0f, 1.0f), left = kernel::real3_of(1.0f, 0.0f, 0.0f), right = kernel::real3_of(-1.0f, 0.0f, 0.0f);
  const kernel::Cosines c = kernel::cosines_of(up, left, right);
  EXPECT_EQ(c.sum2, 0.0f);
  EXPECT_EQ(c.tan2_h, 1e30f);
}

TEST(Facing, NormalsThatPointAwayAreTurnedWhereThereAreTwoSides) {
  float planes[] = {0, 0, 0, 0.6f, 0, -0.8f, 0.8f, 0, -0.6f, 0};  // a position, a normal, the unperturbed one, and the rule
  kernel::Frame frame{};
  frame.plane_stride = 1;
  frame.normal = 3;
  frame.base_normal = 6;
  frame.viewer[2] = 1;
  frame.field[kernel::FIELD_facing].offset = 9;
  for (const int rule : {kernel::FACING_as_stored, kernel::FACING_one_sided, kernel::FACING_two_sided}) {
    planes[9] = static_cast<float>(rule);
    const kernel::Surface s = kernel::load_surface(planes, &frame, nullptr, 0);
    const float sign = rule == kernel::FACING_two_sided ? -1 : 1;
    EXPECT_EQ(s.n.x, sign * planes[3]);
    EXPECT_EQ(s.n.z, sign * planes[5]);
    EXPECT_EQ(s.base_n.x, sign * planes[6]);
    EXPECT_EQ(s.n_v, sign * planes[5]);
  }
  planes[5] = 0.8f;  // towards the viewer already
  EXPECT_EQ(kernel::load_surface(planes, &frame, nullptr, 0).n.z, 0.8f);
}

}  // namespace
}  // namespace relume
