#include "recognition/stripe_blocks.h"

#include <gtest/gtest.h>

#include "tests/common/recognition/wall_scan.h"

namespace geon::recognition {
namespace {

std::vector<StripeBlock> Blocks(const sensor::ScanSet& scan,
                                const std::optional<VerticalRegion>& region,
                                const std::optional<Extent>& rows) {
  return FindStripeBlocks(scan, region, FindRegionProfiles(scan, std::nullopt), rows);
}

TEST(FindStripeBlocks, JoinsNeighboursAndSplitsAtJumps) {
  sensor::ScanSet scan = WallScan(40, 0.02, 0.001);
  for (size_t i = 20; i < 40; ++i) scan.profiles[0].p_L_m[i].x() += 0.1;  // a step back
  const auto blocks = Blocks(scan, std::nullopt, std::nullopt);
  int points = 0;
  for (const StripeBlock& block : blocks) {
    points += block.points;
    EXPECT_NEAR(block.along_L.y(), -1.0, 1e-9);
    const bool near = std::abs(block.p_L_m.x() - 2.0) < 1e-9;
    EXPECT_TRUE(near || std::abs(block.p_L_m.x() - 2.1) < 1e-9);  // no block mixes the two
    EXPECT_EQ(block.place, BlockPlace::kOnTarget);
  }
  EXPECT_GE(points, 36);
  EXPECT_LE(points, 40);
}

TEST(FindStripeBlocks, KnowsWhatLiesBesideTheTarget) {
  const sensor::ScanSet scan = WallScan(40, 0.02, 0.001);
  for (const StripeBlock& block : Blocks(scan, VerticalRegion{-0.01, 0.0}, std::nullopt)) {
    EXPECT_EQ(block.place == BlockPlace::kBeside,
              block.p_L_m.y() < 0.0);  // y to the left, x/z to the right
  }
}

TEST(FindStripeBlocks, TellsByTheRowsWhatAVerticalStripeShowsBesideTheTarget) {
  sensor::ScanSet scan = WallScan(40, 0.0, 0.0);
  scan.profiles[0].laser = sensor::Laser::kVertical;
  for (size_t i = 0; i < 40; ++i)
    scan.profiles[0].p_L_m[i].z() = 0.9 - 0.002 * static_cast<double>(i);
  const Extent rows{0.045, 0.065};  // heights 0.91 to 0.87
  for (const StripeBlock& block : Blocks(scan, std::nullopt, rows)) {
    EXPECT_EQ(block.place == BlockPlace::kBeside, block.p_L_m.z() < 0.87 - 0.08 * 0.04);
    EXPECT_EQ(block.place == BlockPlace::kOnTarget, block.p_L_m.z() > 0.87 + 0.12 * 0.04);
  }
}

TEST(FindStripeBlocks, HasNoneInAnEmptyScan) {
  EXPECT_TRUE(Blocks({}, std::nullopt, std::nullopt).empty());
}

}  // namespace
}  // namespace geon::recognition
