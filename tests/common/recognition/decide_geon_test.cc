#include "recognition/decide_geon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace geon::recognition {
namespace {

using sensor::GeonVerdict;

// Evidence of six profiles, the first `curved` of them curved, the last `cornered` with a corner.
GeonVerdict Evidence(int curved, int cornered) {
  GeonVerdict verdict;
  verdict.profiles.resize(6);
  for (size_t i = 0; i < 6; ++i) {
    verdict.profiles[i].segments = 1;
    verdict.profiles[i].curves = static_cast<int>(i) < curved ? 1 : 0;
    verdict.profiles[i].corners = static_cast<int>(i) >= 6 - cornered ? 1 : 0;
  }
  return verdict;
}

GeonVerdict Bent(GeonVerdict verdict) {
  verdict.bending.concavity = true;
  return verdict;
}

GeonVerdict Tapered(GeonVerdict verdict) {
  verdict.tapering.monotone_horizontal = true;
  return verdict;
}

GeonVerdict Decide(GeonVerdict verdict) {
  DecideGeon(&verdict);
  return verdict;
}

TEST(DecideGeon, FollowsTheTreeOfFigure5_17) {
  EXPECT_EQ(Decide(Bent(Evidence(4, 0))).label, GeonLabel::kBentCylinder);
  EXPECT_EQ(Decide(Bent(Evidence(3, 0))).label, GeonLabel::kBentCuboid);
  EXPECT_EQ(Decide(Tapered(Evidence(2, 6))).label, GeonLabel::kTaperedCylinder);
  EXPECT_EQ(Decide(Tapered(Evidence(1, 6))).label, GeonLabel::kTaperedCuboid);
  EXPECT_EQ(Decide(Evidence(0, 0)).label, GeonLabel::kCuboid);
  EXPECT_EQ(Decide(Evidence(0, 6)).label, GeonLabel::kCuboid);
  EXPECT_EQ(Decide(Evidence(6, 1)).label, GeonLabel::kCylinder);
  EXPECT_EQ(Decide(Evidence(6, 0)).label, GeonLabel::kEllipsoid);
  EXPECT_EQ(Decide(Evidence(5, 0)).label, GeonLabel::kCylinder);
}

TEST(DecideGeon, BendingIsAskedBeforeTapering) {
  EXPECT_EQ(Decide(Bent(Tapered(Evidence(0, 0)))).label, GeonLabel::kBentCuboid);
}

TEST(DecideGeon, ProfilesWithoutPointsAreNotCounted) {
  GeonVerdict verdict = Evidence(4, 0);
  verdict.profiles[4].segments = 0;
  verdict.profiles[5].segments = 0;
  EXPECT_EQ(Decide(verdict).label, GeonLabel::kEllipsoid);
}

TEST(DecideGeon, PosteriorSumsToOneAndPeaksAtTheLabel) {
  for (int curved = 0; curved <= 6; ++curved) {
    for (int cornered = 0; cornered <= 6; ++cornered) {
      for (int kind = 0; kind < 3; ++kind) {
        GeonVerdict verdict = Evidence(curved, cornered);
        if (kind == 1) verdict = Bent(verdict);
        if (kind == 2) verdict = Tapered(verdict);
        verdict = Decide(verdict);
        const auto& p = verdict.posterior;
        EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
        EXPECT_EQ(std::max_element(p.begin(), p.end()) - p.begin(),
                  static_cast<ptrdiff_t>(verdict.label))
            << "curved " << curved << " cornered " << cornered << " kind " << kind;
        EXPECT_EQ(verdict.confidence, p[static_cast<size_t>(verdict.label)]);
      }
    }
  }
}

TEST(DecideGeon, MoreCluesGiveMoreConfidence) {
  GeonVerdict two = Bent(Evidence(5, 0));
  two.bending.two_segments = true;
  EXPECT_GT(Decide(two).confidence, Decide(Bent(Evidence(5, 0))).confidence);
  EXPECT_GT(Decide(Evidence(6, 6)).confidence, Decide(Evidence(6, 1)).confidence);
}

TEST(DecideGeon, TellsItsReasonsInWords) {
  EXPECT_THAT(Decide(Bent(Evidence(4, 0))).reasons,
              testing::ElementsAre("Bent: a profile has a concave part.",
                                   testing::HasSubstr("4 of 6 profiles")));
  EXPECT_THAT(
      Decide(Evidence(0, 0)).reasons,
      testing::ElementsAre(testing::StartsWith("Not bent"), testing::StartsWith("Not tapered"),
                           testing::HasSubstr("cuboid")));
}

}  // namespace
}  // namespace geon::recognition
