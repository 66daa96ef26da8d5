#include "sim/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/rig_renderer.h"
#include "sim/surface_row.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

TEST(ViewTest, PixelsMeetTheFloorWhereTheirRaysSay) {
  const auto scene = SceneFrom("");
  const View view = LookDown(*scene, 1.5, 2.0);
  const Sighting corner = SightingAt(*scene, view, 0, 0);
  EXPECT_NEAR(static_cast<double>(corner.p_W_m.x()), 1.5 - 31.5 / 80 * 2.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(corner.p_W_m.y()), 2.0 + 23.5 / 80 * 2.0, 1e-5);
  EXPECT_EQ(corner.body, 0);
}

TEST(ViewTest, NoRaySlipsThroughBetweenTwoFacets) {
  // The diagonal of the board runs exactly through the middles of pixels.
  const auto scene = BoardScene(geometry::RigidTransform::Identity(), 1.0);
  View view;
  LookThrough(*scene, geometry::PinholeCamera(), geometry::RigidTransform::Identity(), &view);
  EXPECT_EQ(std::count(view.facet.begin(), view.facet.end(), View::kNothing), 0);
  EXPECT_GT(std::count(view.facet.begin(), view.facet.end(), 0), 100000);
  EXPECT_GT(std::count(view.facet.begin(), view.facet.end(), 1), 100000);
  for (const float nearness_1_m : view.nearness_1_m) ASSERT_NEAR(nearness_1_m, 1.0F, 1e-6F);
}

TEST(ViewTest, OutsideOfTheWorldIsNothing) {
  const auto scene = BoardScene(geometry::RigidTransform::Identity(), 1.0);
  Eigen::Matrix3d R_WC;
  R_WC << -1, 0, 0, 0, 1, 0, 0, 0, -1;  // the board is behind
  View view;
  LookThrough(*scene, geometry::PinholeCamera(),
              geometry::MakeTransform(R_WC, Eigen::Vector3d::Zero()), &view);
  EXPECT_EQ(std::count(view.facet.begin(), view.facet.end(), View::kNothing), 640 * 480);
  EXPECT_EQ(SightingAt(*scene, view, 3, 4).body, -1);
}

TEST(ViewTest, WhatIsThinnerThanAPixelIsSeenWhereRaysMeetIt) {
  // 2 mm thick, 3 m away: 1 pixel in 3 of a focal length of 500 px. Leaning, so that some rays hit.
  const auto scene =
      SceneFrom("  - {cylinder: {radius_m: 0.001, height_m: 1.0}, x_m: 1.5, y_m: 4.0}\n");
  const geometry::PinholeCamera camera{320, 240, 500.0, 500.0, 159.5, 119.5};
  Eigen::Matrix3d R_WC;
  R_WC << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  R_WC = R_WC * Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  View view;
  LookThrough(*scene, camera, geometry::MakeTransform(R_WC, {1.5, 1.0, 0.5}), &view);
  const int rod = static_cast<int>(scene->bodies().size()) - 1;
  int seen = 0;
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      const Eigen::Vector3d ray = R_WC * camera.Ray(u, v);
      const auto hit = scene->CastRay({1.5, 1.0, 0.5}, ray);
      const Sighting sighting = SightingAt(*scene, view, u, v);
      ASSERT_EQ(hit.has_value(), sighting.body >= 0);
      if (!hit) continue;
      const Eigen::Vector3d reach = sighting.p_W_m.cast<double>() - Eigen::Vector3d(1.5, 1.0, 0.5);
      ASSERT_NEAR(hit->distance_m, reach.norm(), 1e-4);
      seen += sighting.body == rod ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 20);
  EXPECT_LT(seen, 200);
}

TEST(ViewTest, WhatWasSeenBeforeDoesNotMatter) {
  const auto scene =
      SceneFrom("  - {geon: bent_cuboid, size_m: [0.08, 0.1, 0.3], x_m: 1.5, y_m: 2.0}\n");
  const View fresh = LookDown(*scene, 1.5, 2.0);
  View used = LookDown(*scene, 0.4, 0.4);
  LookThrough(*scene, fresh.camera, fresh.X_WC, &used);
  EXPECT_EQ(fresh.facet, used.facet);
  EXPECT_EQ(fresh.nearness_1_m, used.nearness_1_m);
}

}  // namespace
}  // namespace geon::sim
