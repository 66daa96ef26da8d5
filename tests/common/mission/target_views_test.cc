#include "mission/target_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;

sensor::GeonVerdict Likely(GeonLabel label, double confidence_1) {
  sensor::GeonVerdict verdict;
  verdict.label = label;
  verdict.confidence = confidence_1;
  verdict.posterior.fill((1.0 - confidence_1) / (kGeonLabelCount - 1));
  verdict.posterior[static_cast<size_t>(label)] = confidence_1;
  return verdict;
}

double Between(double a_rad, double b_rad) { return std::abs(WrapAngle(a_rad - b_rad)); }

TEST(TargetViewsTest, TheMiddleIsThatOfAllScans) {
  TargetViews views;
  EXPECT_EQ(views.count(), 0);
  EXPECT_THROW(views.middle_W_m(), ContractViolation);
  EXPECT_THROW(views.Fused(), ContractViolation);
  views.Add(Likely(GeonLabel::kCuboid, 0.5), 0.0, {1.0, 2.0});
  EXPECT_EQ(views.middle_W_m(), Vector2d(1.0, 2.0));
  views.Add(Likely(GeonLabel::kCuboid, 0.5), 1.0, {1.2, 1.8});
  EXPECT_EQ(views.count(), 2);
  EXPECT_NEAR((views.middle_W_m() - Vector2d(1.1, 1.9)).norm(), 0.0, 1e-12);
  views.Clear();
  EXPECT_EQ(views.count(), 0);
}

TEST(TargetViewsTest, TheSurerOfTwoViewsThatContradictEachOtherWins) {
  TargetViews views;
  views.Add(Likely(GeonLabel::kCuboid, 0.5), 0.0, {1.0, 0.0});
  views.Add(Likely(GeonLabel::kCylinder, 0.9), 1.0, {1.0, 0.0});
  EXPECT_EQ(views.Fused().label, GeonLabel::kCylinder);
  views.Add(Likely(GeonLabel::kCuboid, 0.95), 2.0, {1.0, 0.0});
  EXPECT_EQ(views.Fused().label, GeonLabel::kCuboid);
}

TEST(TargetViewsTest, TheNextSideIsNeverOneThatWasSeen) {
  for (const double first_rad : {0.0, 3.0, -2.0}) {
    TargetViews views;
    std::vector<double> seen_rad;
    double bearing_rad = first_rad;
    for (int k = 0; k < 4; ++k) {
      views.Add(Likely(GeonLabel::kCuboid, 0.4), bearing_rad, {1.0, 0.0});
      seen_rad.push_back(bearing_rad);
      const auto next_rad = views.NextBearing();
      ASSERT_TRUE(next_rad.has_value());
      EXPECT_LE(std::abs(*next_rad), kPi);
      for (const double each_rad : seen_rad) {
        EXPECT_GE(Between(*next_rad, each_rad), RadiansFromDegrees(20.0)) << k;
      }
      bearing_rad = *next_rad;
    }
  }
}

TEST(TargetViewsTest, ASideThatIsGivenUpIsNotAskedForAgainAndAtLastThereIsNone) {
  TargetViews views;
  views.Add(Likely(GeonLabel::kCuboid, 0.4), 0.5, {1.0, 0.0});
  std::vector<double> asked_rad;
  while (const auto next_rad = views.NextBearing()) {
    for (const double each_rad : asked_rad) {
      ASSERT_GE(Between(*next_rad, each_rad), RadiansFromDegrees(20.0));
    }
    asked_rad.push_back(*next_rad);
    views.GiveUp(*next_rad);
    ASSERT_LE(asked_rad.size(), 12U);
  }
  EXPECT_GE(asked_rad.size(), 2U);
  views.Clear();
  views.Add(Likely(GeonLabel::kCuboid, 0.4), 0.5, {1.0, 0.0});
  EXPECT_TRUE(views.NextBearing().has_value()) << "of another target all sides are open";
}

}  // namespace
}  // namespace geon::mission
