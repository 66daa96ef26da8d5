#include "recognition/wall_plane.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace geon::recognition {
namespace {

const SupportPlane kFloor{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 0.001, 100};
const Eigen::Vector3d kEye_L_m(0.0, 0.0, 1.0);

// Blocks of three horizontal stripes on an upright plane at 30 degrees to the view.
std::vector<StripeBlock> BlocksOnAWall() {
  const Eigen::Vector3d along_L(0.5, -std::sqrt(0.75), 0.0);
  std::vector<StripeBlock> blocks;
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0.0, 0.001);
  for (const size_t stripe : {0, 1, 2}) {
    const double height_m = 0.05 + 0.07 * static_cast<double>(stripe);
    for (int k = -5; k < 5; ++k) {
      Eigen::Vector3d p_m = Eigen::Vector3d(1.5, 0.0, height_m) + 0.02 * k * along_L;
      p_m.x() += gauss(random);
      blocks.push_back({p_m, along_L, 0.001, 8, BlockPlace::kBeside, stripe});
    }
  }
  return blocks;
}

TEST(FindWallPlane, FindsAWallAndWhichSideIsBeforeIt) {
  const auto wall = FindWallPlane(BlocksOnAWall(), kFloor, kEye_L_m);
  ASSERT_TRUE(wall.has_value());
  EXPECT_NEAR(wall->Before({1.5, 0.0, 0.1}), 0.0, 0.002);
  EXPECT_GT(wall->Before({1.3, 0.0, 0.1}), 0.1);
  EXPECT_NEAR(wall->normal_L.z(), 0.0, 1e-9);
  EXPECT_LT(wall->sigma_m, 0.003);
}

TEST(FindWallPlane, NeedsBlocksBesideTheTargetAndAboveTheSupport) {
  std::vector<StripeBlock> blocks = BlocksOnAWall();
  for (StripeBlock& block : blocks) block.place = BlockPlace::kAtFoot;
  EXPECT_FALSE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
  blocks = BlocksOnAWall();
  for (StripeBlock& block : blocks) block.p_L_m.z() = 0.01;
  EXPECT_FALSE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
  EXPECT_FALSE(FindWallPlane({}, kFloor, kEye_L_m).has_value());
}

TEST(FindWallPlane, ASingleStripeIsNoWall) {
  std::vector<StripeBlock> blocks = BlocksOnAWall();
  for (StripeBlock& block : blocks) block.p_L_m.z() = 0.1;
  EXPECT_FALSE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
}

// A vertical stripe over a near thing and a far one spreads both ways, on the plane of its fan.
TEST(FindWallPlane, TheFanOfAStripeIsNoWall) {
  std::vector<StripeBlock> blocks;
  for (int k = 0; k < 15; ++k) {
    const double up_m = 0.03 + 0.01 * k;
    blocks.push_back({{1.0, 0.1, up_m}, {0.0, 0.0, 1.0}, 0.001, 8, BlockPlace::kBeside, 4});
  }
  blocks.push_back({{2.0, 0.2, 0.05}, {0.995, 0.0995, 0.0}, 0.001, 8, BlockPlace::kBeside, 4});
  EXPECT_FALSE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
  blocks.back().stripe = 1;  // another stripe says the same
  EXPECT_TRUE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
}

TEST(FindWallPlane, SomethingRoundIsNoWall) {
  std::vector<StripeBlock> blocks;
  for (const double height_m : {0.05, 0.12, 0.2}) {
    for (int k = 0; k < 20; ++k) {
      const double angle_rad = 0.12 * k;
      const Eigen::Vector3d out(-std::sin(angle_rad), std::cos(angle_rad), 0.0);
      blocks.push_back({Eigen::Vector3d(1.3, 0.1, height_m) + 0.15 * out,
                        Eigen::Vector3d(out.y(), -out.x(), 0.0), 0.001, 8, BlockPlace::kBeside});
    }
  }
  EXPECT_FALSE(FindWallPlane(blocks, kFloor, kEye_L_m).has_value());
}

}  // namespace
}  // namespace geon::recognition
