#include "sim/random_world.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/world_file.h"

namespace geon::sim {
namespace {

TEST(RandomWorldTest, SameSeedSameWorldAndOtherSeedsOthers) {
  EXPECT_EQ(WorldText(RandomWorld(5, GeonPlace::kAny)), WorldText(RandomWorld(5, GeonPlace::kAny)));
  EXPECT_NE(WorldText(RandomWorld(5, GeonPlace::kAny)), WorldText(RandomWorld(6, GeonPlace::kAny)));
}

TEST(RandomWorldTest, EveryWorldIsGoodAndShowsEveryShapeInTheEnd) {
  std::set<GeonLabel> labels;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const World world = RandomWorld(seed, GeonPlace::kAny);
    const Result<World> read = ParseWorld(WorldText(world), "random.yaml", "");
    ASSERT_TRUE(read.ok()) << read.message();
    const WorldObject& geon = world.objects.back();
    ASSERT_TRUE(TrueLabel(geon).has_value());
    labels.insert(*TrueLabel(geon));
    EXPECT_GE(std::hypot(geon.x_m - world.robot_x_m, geon.y_m - world.robot_y_m), 1.5);
    // Nothing but the geon is red.
    for (size_t k = 0; k + 1 < world.objects.size(); ++k) {
      const Eigen::Vector3d& color = world.objects[k].color_rgb;
      EXPECT_LT(color[0], color[1] + color[2]);
    }
  }
  EXPECT_EQ(labels.size(), static_cast<size_t>(kGeonLabelCount));
}

TEST(RandomWorldTest, TheGeonStandsWhereItWasAsked) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const World on_floor = RandomWorld(seed, GeonPlace::kFloor);
    EXPECT_DOUBLE_EQ(FootHeight(on_floor, on_floor.objects.back()), 0.0);
    const World on_box = RandomWorld(seed, GeonPlace::kBox);
    EXPECT_DOUBLE_EQ(FootHeight(on_box, on_box.objects.back()), 0.7);
  }
}

TEST(RandomWorldTest, ABarrierAcrossThePenCannotBePassed) {
  World world;
  world.robot_x_m = 1.5;
  world.robot_y_m = 0.6;
  const Eigen::Vector2d goal_m(1.5, 3.8);
  EXPECT_TRUE(CanReach(world, goal_m, 0.8, 1.0, 0.1));
  WorldObject barrier;
  barrier.shape = BoxShape{{3.0, 0.1, 0.5}};
  barrier.x_m = 1.5;
  barrier.y_m = 2.0;
  world.objects.push_back(barrier);
  EXPECT_FALSE(CanReach(world, goal_m, 0.8, 1.0, 0.1));
}

}  // namespace
}  // namespace geon::sim
