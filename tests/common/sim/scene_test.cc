#include "sim/scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "sim/noise_source.h"
#include "sim/random_pen.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

TEST(SceneTest, RaysMeetWallsBoxesAndCylindersAtTheirDistances) {
  const auto scene = SceneFrom(
      "  - {box: [0.4, 0.6, 0.7], x_m: 1.0, y_m: 3.0, yaw_deg: 0}\n"
      "  - {cylinder: {radius_m: 0.1, height_m: 1.0}, x_m: 2.0, y_m: 3.0}\n");
  const auto wall = scene->CastRay({1.5, 1.0, 0.3}, {-1, 0, 0});
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->distance_m, 1.5, 1e-5);
  EXPECT_NEAR((wall->normal_W - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-5);
  const auto floor = scene->CastRay({1.5, 1.0, 1.2}, Eigen::Vector3d(1, 0, -1).normalized());
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->distance_m, 1.2 * std::sqrt(2.0), 1e-5);
  const auto box = scene->CastRay({1.0, 1.0, 0.5}, {0, 1, 0});
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->distance_m, 1.7, 1e-5);
  EXPECT_NEAR((box->normal_W + Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-5);
  const auto cylinder = scene->CastRay({2.05, 1.0, 0.5}, {0, 1, 0});
  ASSERT_TRUE(cylinder);
  EXPECT_NEAR(cylinder->distance_m, 2.0 - std::sqrt(0.1 * 0.1 - 0.05 * 0.05), 1e-4);
  EXPECT_NEAR(cylinder->normal_W.x(), 0.5, 0.02);
  EXPECT_FALSE(scene->CastRay({1.5, 1.0, 1.2}, {0, 0, 1}).has_value());
}

TEST(SceneTest, AboveTheWallsRaysLeaveThePen) {
  const auto scene = SceneFrom("");
  EXPECT_TRUE(scene->CastRay({1.5, 1.0, 0.64}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(scene->CastRay({1.5, 1.0, 0.66}, {-1, 0, 0}).has_value());
}

TEST(SceneTest, WithinReachARayMeetsTheSame) {
  const auto scene = SceneFrom("");
  const auto endless = scene->CastRay({1.5, 1.0, 0.3}, {-1, 0, 0});
  const auto reaching = scene->CastRay({1.5, 1.0, 0.3}, {-1, 0, 0}, 1.5);
  ASSERT_TRUE(endless && reaching);
  EXPECT_EQ(endless->distance_m, reaching->distance_m);
  EXPECT_FALSE(scene->CastRay({1.5, 1.0, 0.3}, {-1, 0, 0}, 1.4).has_value());
}

TEST(SceneTest, GroundIsOpenUpToWhatStandsOnIt) {
  NoiseSource random(5);
  int met = 0;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const World world = RandomPen(seed, MixedPenKind(seed));
    const auto scene = *BuildScene(world);
    for (int round = 0; round < 100; ++round) {
      const double bearing_rad = random.Uniform(-kPi, kPi);
      const Eigen::Vector2d bearing(std::cos(bearing_rad), std::sin(bearing_rad));
      const Eigen::Vector2d from_m(world.robot_x_m, world.robot_y_m);
      const double open_m = scene->OpenGround_m(from_m, bearing);
      // Just over the floor a level ray meets the same, the geon's rounded edge nearly.
      const auto hit =
          scene->CastRay({from_m.x(), from_m.y(), 0.02}, {bearing.x(), bearing.y(), 0.0});
      ASSERT_TRUE(hit.has_value());
      EXPECT_NEAR(open_m, hit->distance_m, 0.01);
      EXPECT_LT(open_m, hit->distance_m + 1e-5);
      ++met;
    }
  }
  EXPECT_EQ(met, 600);
  EXPECT_TRUE(std::isinf(SceneFrom("")->OpenGround_m({-1.0, 1.0}, {-1.0, 0.0})));
}

TEST(SceneTest, EllipsoidIsMetOnItsSurfaceWithItsNormal) {
  const auto scene =
      SceneFrom("  - {geon: ellipsoid, size_m: [0.2, 0.2, 0.2], x_m: 1.5, y_m: 3.0}\n");
  const double offset_m = 0.06;
  const auto hit = scene->CastRay({1.5 + offset_m, 1.0, 0.1}, {0, 1, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance_m, 2.0 - std::sqrt(0.01 - offset_m * offset_m), 2e-5);
  EXPECT_NEAR(hit->normal_W.x(), 0.6, 5e-3);
  EXPECT_NEAR(hit->normal_W.z(), 0.0, 5e-3);
}

TEST(SceneTest, AlonePacketAndNeighboursGiveTheSameBits) {
  const auto scene =
      SceneFrom("  - {geon: bent_cuboid, size_m: [0.08, 0.1, 0.3], x_m: 1.5, y_m: 3.0}\n");
  std::vector<Eigen::Vector3f> directions;
  for (int k = 0; k < 37; ++k) {
    directions.emplace_back(-0.2F + 0.011F * static_cast<float>(k), 1.0F, -0.4F);
  }
  std::vector<Sighting> together(directions.size());
  scene->Look({1.5F, 1.0F, 1.2F}, directions, together);
  for (size_t k = 0; k < directions.size(); ++k) {
    Sighting alone;
    scene->Look({1.5F, 1.0F, 1.2F}, {&directions[k], 1}, {&alone, 1});
    EXPECT_EQ(alone.p_W_m, together[k].p_W_m);
    EXPECT_EQ(alone.body, together[k].body);
  }
}

TEST(SceneTest, LightIsStoppedByWhatStandsBetween) {
  const auto scene = SceneFrom("  - {box: [0.4, 0.4, 0.7], x_m: 1.5, y_m: 3.0}\n");
  const std::vector<Eigen::Vector3f> points = {
      {1.5F, 4.0F, 0.0F}, {0.5F, 4.0F, 0.0F}, {1.5F, 2.8F, 0.3F}};
  std::vector<uint8_t> lit(points.size());
  scene->Illuminate({1.5F, 1.0F, 0.5F}, points, lit);
  EXPECT_EQ(lit, (std::vector<uint8_t>{0, 1, 1}));
}

TEST(SceneTest, DiscFeelsWallsAndBoxesWithinReach) {
  const auto scene = SceneFrom("  - {box: [0.4, 0.4, 0.7], x_m: 1.5, y_m: 3.0}\n");
  EXPECT_TRUE(scene->ContactsOfDisc({1.5, 1.5}, 0.267).empty());
  const auto near_box = scene->ContactsOfDisc({1.5, 2.8 - 0.267 - 0.02}, 0.267);
  ASSERT_EQ(near_box.size(), 1u);
  EXPECT_NEAR(near_box[0].clearance_m, 0.02, 1e-9);
  EXPECT_NEAR(near_box[0].bearing_rad, kPi / 2, 1e-9);
  const auto in_corner = scene->ContactsOfDisc({0.26, 0.26}, 0.267);
  ASSERT_EQ(in_corner.size(), 2u);
  for (const DiscContact& contact : in_corner) EXPECT_NEAR(contact.clearance_m, -0.007, 1e-9);
}

TEST(SceneTest, WhatStandsAboveTheRobotIsNotInItsWay) {
  const auto scene = SceneFrom("  - {box: [0.4, 0.4, 0.1], x_m: 1.5, y_m: 3.0, z_m: 1.1}\n");
  EXPECT_TRUE(scene->ContactsOfDisc({1.5, 3.0}, 0.267).empty());
}

TEST(SceneTest, MeshWithoutNormalsIsAContractViolation) {
  Body body;
  body.surface_W.vertices_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  body.surface_W.triangles = {{0, 1, 2}};
  EXPECT_THROW(Scene({body}, Lighting()), ContractViolation);
}

}  // namespace
}  // namespace geon::sim
