#include "mission/scan_geometry.h"

#include <gtest/gtest.h>

namespace geon::mission {
namespace {

sensor::RangeProfile ProfileAt(double distance_m, int from_px, int to_px) {
  sensor::RangeProfile profile;
  for (int u = from_px; u < to_px; ++u) {
    profile.pixel.push_back(u);
    profile.p_L_m.emplace_back(distance_m, 0.0, 0.1);
  }
  return profile;
}

TEST(MeasuredDistanceTest, CountsTheMiddleOfTheTargetOnly) {
  const geometry::PinholeCamera camera;
  sensor::RangeProfile profile = ProfileAt(3.0, 0, 200);  // the wall beside
  const auto target = ProfileAt(1.2, 270, 370);
  profile.pixel.insert(profile.pixel.end(), target.pixel.begin(), target.pixel.end());
  profile.p_L_m.insert(profile.p_L_m.end(), target.p_L_m.begin(), target.p_L_m.end());
  EXPECT_NEAR(MeasuredDistance(profile, camera, 100).value(), 1.2, 1e-12);
}

TEST(MeasuredDistanceTest, AHandfulOfPointsTellsNothing) {
  const geometry::PinholeCamera camera;
  EXPECT_FALSE(MeasuredDistance(ProfileAt(1.2, 316, 322), camera, 100).has_value());
}

}  // namespace
}  // namespace geon::mission
