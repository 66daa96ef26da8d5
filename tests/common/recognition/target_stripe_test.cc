#include "recognition/target_stripe.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/rigid_transform.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

TargetView FindView(const sensor::ScanSet& scan) {
  const auto region = FindVerticalRegion(scan, {});
  const auto parts = FindRegionProfiles(scan, region);
  return FindTargetView(scan, region, parts, LabelPoints(scan, region, parts, {}), {}, {});
}

sensor::ScanSet Scan() { return *ScanOfGeon(PlainGeons()[0], 0.3, {}, 1); }

TEST(FindTargetView, GivesSixInTheirOrder) {
  sensor::ScanSet scan = Scan();
  std::reverse(scan.profiles.begin(), scan.profiles.end());
  const auto stripes = FindView(scan).stripes;
  ASSERT_EQ(stripes.size(), 6U);
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(stripes[k].laser, k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical);
    EXPECT_DOUBLE_EQ(stripes[k].fraction, 0.25 * static_cast<double>(k % 3 + 1));
    EXPECT_EQ(stripes[k].p_L_m.size(), stripes[k].curve_m.size());
    EXPECT_FALSE(stripes[k].empty());
  }
}

TEST(FindTargetView, LeavesAMissingStripeEmpty) {
  sensor::ScanSet scan = Scan();
  scan.profiles.erase(scan.profiles.begin() + 4);
  const auto stripes = FindView(scan).stripes;
  ASSERT_EQ(stripes.size(), 6U);
  EXPECT_TRUE(stripes[4].empty());
  EXPECT_FALSE(stripes[5].empty());
}

TEST(FindTargetView, DropsASpike) {
  sensor::ScanSet scan = Scan();
  auto& points = scan.profiles[1].p_L_m;
  const size_t middle = points.size() / 2;
  const Eigen::Vector3d ray = (points[middle] - scan.camera_position_L_m).normalized();
  points[middle] -= 0.03 * ray;
  const Eigen::Vector3d spike = points[middle];
  const auto stripes = FindView(scan).stripes;
  for (const Eigen::Vector3d& p_L : stripes[1].p_L_m) {
    EXPECT_GT((p_L - spike).norm(), 0.01);
  }
}

// Six stripes on an upright panel of 20 cm, 1 m before a level camera, and of each vertical one 20
// points on something 15 cm behind, seen over the panel's upper edge.
sensor::ScanSet PanelBeforeSomething() {
  sensor::ScanSet scan;
  scan.camera_position_L_m = Eigen::Vector3d(0.0, 0.0, 0.5);
  scan.rotation_LB = geometry::CameraAxesInBody();
  scan.target_box = sensor::PixelBox{160, 160, 321, 321};
  for (int k = 0; k < 6; ++k) {
    sensor::RangeProfile profile;
    profile.laser = k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical;
    profile.fraction = 0.25 * (k % 3 + 1);
    const double at_m = 0.1 - 0.2 * profile.fraction;  // left or up
    for (int i = k < 3 ? 0 : -20; i <= 320; ++i) {
      const double along_m = 0.1 - i / 1600.0;
      const double depth_m = i < 0 ? 1.15 : 1.0;
      profile.pixel.push_back(160 + i);
      profile.p_L_m.emplace_back(depth_m, depth_m * (k < 3 ? along_m : at_m),
                                 0.5 + depth_m * (k < 3 ? at_m : along_m));
    }
    scan.profiles.push_back(profile);
  }
  return scan;
}

TEST(FindTargetView, LeavesOutWhatStandsBehindTheTarget) {
  const TargetView view = FindView(PanelBeforeSomething());
  for (const TargetStripe& stripe : view.stripes) {
    ASSERT_EQ(stripe.segment_begins.size(), 1U);
    for (const Eigen::Vector3d& p_m : stripe.p_L_m) EXPECT_NEAR(p_m.x(), 1.0, 1e-9);
  }
}

TEST(FindTargetView, LeavesOutWhatStandsBesideTheTarget) {
  sensor::ScanSet scan = PanelBeforeSomething();
  scan.target_box->w_px = 280;  // the rest of the panel is another's
  sensor::RangeProfile& profile = scan.profiles[0];
  for (size_t i = 282; i < profile.p_L_m.size(); ++i) profile.p_L_m[i] *= 1.1;
  const TargetStripe stripe = FindView(scan).stripes[0];
  EXPECT_EQ(stripe.segment_begins.size(), 1U);
  EXPECT_NEAR(static_cast<double>(stripe.p_L_m.size()), 282.0, 1.0);
}

TEST(FindTargetView, LeavesOutEndsThatAreDrawnOutAlongTheRays) {
  sensor::ScanSet scan = Scan();
  const TargetView alone = FindView(scan);
  sensor::RangeProfile& profile = scan.profiles[1];
  size_t last = 0;  // on the target
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    if (profile.p_L_m[i].z() > 0.02) last = i;
  }
  for (int i = 1; i <= 8; ++i) {
    const Eigen::Vector3d ray = (profile.p_L_m[last] - scan.camera_position_L_m).normalized();
    profile.p_L_m.insert(profile.p_L_m.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                         profile.p_L_m[last] + 0.004 * (9 - i) * ray);
    profile.pixel.insert(profile.pixel.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                         profile.pixel[last] + 1);
  }
  const TargetView view = FindView(scan);
  EXPECT_NEAR(static_cast<double>(view.stripes[1].p_L_m.size()),
              static_cast<double>(alone.stripes[1].p_L_m.size()), 4.0);
}

}  // namespace
}  // namespace geon::recognition
