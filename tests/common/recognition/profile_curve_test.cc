#include "recognition/profile_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points Line(double from_m, double to_m, int count) {
  Points points_m;
  for (int i = 0; i < count; ++i) {
    points_m.emplace_back(1.0, from_m + (to_m - from_m) * i / (count - 1), 0.5);
  }
  return points_m;
}

TEST(FindSegments, AHoleInSpaceSplitsAndAMissingPixelDoesNot) {
  Points points_m = Line(0.0, 0.1, 51);
  EXPECT_EQ(FindSegments(points_m, {}).size(), 1U);
  points_m.erase(points_m.begin() + 20, points_m.begin() + 24);
  EXPECT_EQ(FindSegments(points_m, {}).size(), 1U);
  for (size_t i = 25; i < points_m.size(); ++i) points_m[i].x() += 0.05;
  const auto segments = FindSegments(points_m, {});
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].size(), 25U);
  EXPECT_EQ(segments[1].begin, 25U);
  EXPECT_EQ(segments[1].end, points_m.size());
}

TEST(FindSegments, DropsStrayReflections) {
  Points points_m = Line(0.0, 0.1, 51);
  points_m.emplace_back(1.0, 0.2, 0.5);
  const auto segments = FindSegments(points_m, {});
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].size(), 51U);
}

TEST(FindSegments, DropsWhatIsShortBesideTheLongest) {
  Points points_m = Line(0.0, 0.1, 51);
  for (int k = 0; k < 12; ++k) points_m.emplace_back(1.0, 0.2 + 0.002 * k, 0.5);  // 22 mm
  SegmentOptions options;
  options.shortest_m = 0.015;
  options.shortest_share_1 = 0.2;
  EXPECT_EQ(FindSegments(points_m, options).size(), 2U);
  options.shortest_share_1 = 0.25;
  EXPECT_EQ(FindSegments(points_m, options).size(), 1U);
}

TEST(FindSegments, NothingGivesNothing) { EXPECT_TRUE(FindSegments({}, {}).empty()); }

TEST(PlaneCurve, RunsAlongTheStripeAndTowardsTheCamera) {
  const Eigen::Matrix3d R_LB = geometry::CameraAxesInBody();
  const Points points_m = {{1.0, -0.2, 0.7}};
  EXPECT_TRUE(PlaneCurve(points_m, sensor::Laser::kHorizontal, R_LB)[0].isApprox(
      Eigen::Vector2d(0.2, -1.0)));
  EXPECT_TRUE(PlaneCurve(points_m, sensor::Laser::kVertical, R_LB)[0].isApprox(
      Eigen::Vector2d(-0.7, -1.0)));
}

using Curve = std::vector<Eigen::Vector2d>;

Curve Resampled(const Curve& curve_m, int samples) {
  return ResampleEqualArc(curve_m, ArcLengths(curve_m), samples);
}

TEST(ResampleEqualArc, StepsAreEqualHoweverThePointsLay) {
  // A quarter circle, its points crowded at one end.
  std::vector<Eigen::Vector2d> arc_m;
  for (int i = 0; i <= 400; ++i) {
    const double angle_rad = 0.5 * kPi * std::pow(i / 400.0, 3.0);
    arc_m.emplace_back(0.1 * std::cos(angle_rad), 0.1 * std::sin(angle_rad));
  }
  const auto even_m = Resampled(arc_m, 50);
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
  for (const Eigen::Vector2d& p : Resampled(line_m, 40)) EXPECT_LT(std::abs(p.y()), 1e-5);
}

TEST(ResampleEqualArc, OfOnePlaceIsThatPlace) {
  const std::vector<Eigen::Vector2d> still_m(5, Eigen::Vector2d(0.2, -1.0));
  for (const Eigen::Vector2d& p : Resampled(still_m, 4)) EXPECT_EQ(p, still_m[0]);
}

TEST(ArcLengths, GrowToTheLengthOfTheCurve) {
  const std::vector<Eigen::Vector2d> curve_m = {{0, 0}, {3, 4}, {3, 4}, {3, 6}};
  EXPECT_EQ(ArcLengths(curve_m), (std::vector<double>{0, 5, 5, 7}));
  EXPECT_EQ(ArcLength(curve_m), 7.0);
}

TEST(ResampleEqualArc, RefusesTooFewPointsOrSamples) {
  const std::vector<Eigen::Vector2d> point = {{0, 0}};
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 0}};
  EXPECT_THROW(Resampled(point, 10), ContractViolation);
  EXPECT_THROW(Resampled(line, 1), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
