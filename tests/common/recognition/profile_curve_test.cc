#include "recognition/profile_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

sensor::RangeProfile Line(double from_m, double to_m, int points) {
  sensor::RangeProfile profile;
  for (int i = 0; i < points; ++i) {
    profile.pixel.push_back(i);
    profile.p_L_m.emplace_back(1.0, from_m + (to_m - from_m) * i / (points - 1), 0.5);
  }
  return profile;
}

TEST(SplitIntoSegments, AHoleInSpaceSplitsAndAMissingPixelDoesNot) {
  auto profile = Line(0.0, 0.1, 51);
  EXPECT_EQ(SplitIntoSegments(profile, {}).size(), 1U);
  profile.pixel.erase(profile.pixel.begin() + 20, profile.pixel.begin() + 24);
  profile.p_L_m.erase(profile.p_L_m.begin() + 20, profile.p_L_m.begin() + 24);
  EXPECT_EQ(SplitIntoSegments(profile, {}).size(), 1U);
  for (size_t i = 25; i < profile.p_L_m.size(); ++i) profile.p_L_m[i].x() += 0.05;
  const auto segments = SplitIntoSegments(profile, {});
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].pixel.size(), 25U);
  EXPECT_EQ(segments[0].pixel.size() + segments[1].pixel.size(), profile.pixel.size());
}

TEST(SplitIntoSegments, DropsStrayReflections) {
  auto profile = Line(0.0, 0.1, 51);
  profile.pixel.push_back(80);
  profile.p_L_m.emplace_back(1.0, 0.2, 0.5);
  const auto segments = SplitIntoSegments(profile, {});
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].pixel.size(), 51U);
}

TEST(SplitIntoSegments, DropsWhatIsShortBesideTheLongest) {
  auto profile = Line(0.0, 0.1, 51);
  for (int k = 0; k < 12; ++k) {  // 22 mm
    profile.pixel.push_back(80 + k);
    profile.p_L_m.emplace_back(1.0, 0.2 + 0.002 * k, 0.5);
  }
  SegmentOptions options;
  options.shortest_m = 0.015;
  options.shortest_share_1 = 0.2;
  EXPECT_EQ(SplitIntoSegments(profile, options).size(), 2U);
  options.shortest_share_1 = 0.25;
  EXPECT_EQ(SplitIntoSegments(profile, options).size(), 1U);
}

TEST(SplitIntoSegments, NothingGivesNothing) { EXPECT_TRUE(SplitIntoSegments({}, {}).empty()); }

TEST(PlaneCurve, RunsAlongTheStripeAndTowardsTheCamera) {
  const Eigen::Matrix3d R_LB = geometry::CameraAxesInBody();
  sensor::RangeProfile profile;
  profile.p_L_m = {{1.0, -0.2, 0.7}};
  profile.laser = sensor::Laser::kHorizontal;
  EXPECT_TRUE(PlaneCurve(profile, R_LB)[0].isApprox(Eigen::Vector2d(0.2, -1.0)));
  profile.laser = sensor::Laser::kVertical;
  EXPECT_TRUE(PlaneCurve(profile, R_LB)[0].isApprox(Eigen::Vector2d(-0.7, -1.0)));
}

TEST(ResampleEqualArc, StepsAreEqualHoweverThePointsLay) {
  // A quarter circle, its points crowded at one end.
  std::vector<Eigen::Vector2d> arc_m;
  for (int i = 0; i <= 400; ++i) {
    const double angle_rad = 0.5 * kPi * std::pow(i / 400.0, 3.0);
    arc_m.emplace_back(0.1 * std::cos(angle_rad), 0.1 * std::sin(angle_rad));
  }
  const auto even_m = ResampleEqualArc(arc_m, 50);
  ASSERT_EQ(even_m.size(), 50U);
  const double step_m = 0.1 * 0.5 * kPi / 50;
  for (size_t i = 1; i < even_m.size(); ++i) {
    EXPECT_NEAR((even_m[i] - even_m[i - 1]).norm(), step_m, 0.01 * step_m);
    EXPECT_NEAR(even_m[i].norm(), 0.1, 1e-4);
  }
}

TEST(ResampleEqualArc, AveragesNoiseAway) {
  std::vector<Eigen::Vector2d> line_m;
  for (int i = 0; i <= 1000; ++i) line_m.emplace_back(0.001 * i, i % 2 == 0 ? 1e-4 : -1e-4);
  for (const Eigen::Vector2d& p : ResampleEqualArc(line_m, 40)) EXPECT_LT(std::abs(p.y()), 1e-5);
}

TEST(ResampleEqualArc, OfOnePlaceIsThatPlace) {
  const std::vector<Eigen::Vector2d> still_m(5, Eigen::Vector2d(0.2, -1.0));
  for (const Eigen::Vector2d& p : ResampleEqualArc(still_m, 4)) EXPECT_EQ(p, still_m[0]);
}

TEST(ArcLengths, GrowToTheLengthOfTheCurve) {
  const std::vector<Eigen::Vector2d> curve_m = {{0, 0}, {3, 4}, {3, 4}, {3, 6}};
  EXPECT_EQ(ArcLengths(curve_m), (std::vector<double>{0, 5, 5, 7}));
  EXPECT_EQ(ArcLength(curve_m), 7.0);
}

TEST(ResampleEqualArc, RefusesTooFewPointsOrSamples) {
  const std::vector<Eigen::Vector2d> point = {{0, 0}};
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 0}};
  EXPECT_THROW(ResampleEqualArc(point, 10), ContractViolation);
  EXPECT_THROW(ResampleEqualArc(line, 1), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
