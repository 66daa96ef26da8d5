#include "sim/world.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::sim {
namespace {

TEST(WorldTest, OutlineOfATurnedBoxIsTurned) {
  WorldObject box;
  box.shape = BoxShape{{0.4, 0.2, 0.7}};
  box.x_m = 1.0;
  box.y_m = 2.0;
  box.yaw_rad = kPi / 2;
  const auto outline = BoxOutline(box);
  ASSERT_EQ(outline.size(), 4u);
  EXPECT_NEAR((outline[0] - Eigen::Vector2d(1.1, 1.8)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((outline[2] - Eigen::Vector2d(0.9, 2.2)).norm(), 0.0, 1e-12);
}

TEST(WorldTest, OutlineOfSomethingElseIsAContractViolation) {
  WorldObject cylinder;
  cylinder.shape = CylinderShape{};
  EXPECT_THROW(BoxOutline(cylinder), ContractViolation);
}

TEST(WorldTest, OfTwoBoxesTheHigherCarries) {
  World world;
  for (const double height_m : {0.3, 0.5}) {
    WorldObject box;
    box.shape = BoxShape{{0.4, 0.4, height_m}};
    world.objects.push_back(box);
  }
  WorldObject geon;
  geon.shape = geons::GeonShape{};
  EXPECT_DOUBLE_EQ(FootHeight(world, geon), 0.5);
  geon.x_m = 0.3;
  EXPECT_DOUBLE_EQ(FootHeight(world, geon), 0.0);
}

TEST(WorldTest, TheNearestTargetIsAGeonOrAMeshAndNeverABox) {
  World world;
  EXPECT_EQ(NearestTarget(world, {0.0, 0.0}), nullptr);
  world.objects.resize(1);
  world.objects[0].shape = BoxShape{};
  EXPECT_EQ(NearestTarget(world, {0.0, 0.0}), nullptr);
  world.objects.resize(3);  // the box, a geon and a mesh
  world.objects[1].x_m = -1.0;
  world.objects[2].shape = MeshShape{};
  world.objects[2].x_m = 1.0;
  EXPECT_EQ(NearestTarget(world, {-0.1, 0.5}), &world.objects[1]);
  EXPECT_EQ(NearestTarget(world, {0.1, 0.5}), &world.objects[2]);
}

}  // namespace
}  // namespace geon::sim
