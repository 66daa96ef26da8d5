#include "recognition/target_stripe.h"

#include <gtest/gtest.h>

#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

sensor::ScanSet Scan() { return *ScanOfGeon(PlainGeons()[0], 0.3, {}, 1); }

TEST(FindTargetStripes, GivesSixInTheirOrder) {
  sensor::ScanSet scan = Scan();
  std::reverse(scan.profiles.begin(), scan.profiles.end());
  const auto stripes = FindTargetStripes(scan, {}, {});
  ASSERT_EQ(stripes.size(), 6U);
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(stripes[k].laser, k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical);
    EXPECT_DOUBLE_EQ(stripes[k].fraction, 0.25 * static_cast<double>(k % 3 + 1));
    EXPECT_EQ(stripes[k].p_L_m.size(), stripes[k].curve_m.size());
    EXPECT_FALSE(stripes[k].empty());
  }
}

TEST(FindTargetStripes, LeavesAMissingStripeEmpty) {
  sensor::ScanSet scan = Scan();
  scan.profiles.erase(scan.profiles.begin() + 4);
  const auto stripes = FindTargetStripes(scan, {}, {});
  ASSERT_EQ(stripes.size(), 6U);
  EXPECT_TRUE(stripes[4].empty());
  EXPECT_FALSE(stripes[5].empty());
}

TEST(FindTargetStripes, DropsASpike) {
  sensor::ScanSet scan = Scan();
  auto& points = scan.profiles[1].p_L_m;
  const size_t middle = points.size() / 2;
  const Eigen::Vector3d ray = (points[middle] - scan.camera_position_L_m).normalized();
  points[middle] -= 0.03 * ray;
  const Eigen::Vector3d spike = points[middle];
  const auto stripes = FindTargetStripes(scan, {}, {});
  for (const Eigen::Vector3d& p_L : stripes[1].p_L_m) {
    EXPECT_GT((p_L - spike).norm(), 0.01);
  }
}

}  // namespace
}  // namespace geon::recognition
