#include "recognition/find_bending.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Three horizontal stripes 5 cm apart at 1 m, with these left and right ends.
std::vector<ProfileEnds> Horizontal(const std::array<double, 3>& left_m,
                                    const std::array<double, 3>& right_m) {
  std::vector<ProfileEnds> ends;
  for (size_t i = 0; i < 3; ++i) {
    const double y_m = 0.05 * (static_cast<double>(i) - 1.0);
    ProfileEnds e;
    e.first_B_m = {left_m[i], y_m, 1.0};
    e.last_B_m = {right_m[i], y_m, 1.0};
    ends.push_back(e);
  }
  return ends;
}

// The same turned: top and bottom ends of three vertical stripes.
std::vector<ProfileEnds> Vertical(const std::array<double, 3>& top_m,
                                  const std::array<double, 3>& bottom_m) {
  std::vector<ProfileEnds> ends = Horizontal(top_m, bottom_m);
  for (ProfileEnds& e : ends) {
    std::swap(e.first_B_m.x(), e.first_B_m.y());
    std::swap(e.last_B_m.x(), e.last_B_m.y());
  }
  return ends;
}

constexpr std::array<double, 3> kStraightLeft_m = {-0.1, -0.1, -0.1};
constexpr std::array<double, 3> kStraightRight_m = {0.1, 0.1, 0.1};

sensor::BendingEvidence Ends(const std::vector<ProfileEnds>& horizontal,
                             const std::vector<ProfileEnds>& vertical = {}) {
  return FindBending({}, horizontal, vertical, {});
}

TEST(FindBending, TwoSegmentsMeanBending) {
  std::vector<sensor::ProfileEvidence> profiles(6);
  EXPECT_FALSE(FindBending(profiles, {}, {}, {}).found());
  profiles[3].segments = 2;
  const auto bending = FindBending(profiles, {}, {}, {});
  EXPECT_TRUE(bending.two_segments);
  EXPECT_TRUE(bending.found());
}

TEST(FindBending, AConcavityMeansBending) {
  std::vector<sensor::ProfileEvidence> profiles(6);
  profiles[0].concavities = 1;
  EXPECT_TRUE(FindBending(profiles, {}, {}, {}).concavity);
}

TEST(FindBending, FindsAConcaveEdgeOnEachOfTheFourSides) {
  EXPECT_TRUE(Ends(Horizontal({-0.1, -0.08, -0.1}, kStraightRight_m)).concave_edge);
  EXPECT_TRUE(Ends(Horizontal(kStraightLeft_m, {0.1, 0.08, 0.1})).concave_edge);
  EXPECT_TRUE(Ends({}, Vertical({-0.1, -0.08, -0.1}, kStraightRight_m)).concave_edge);
  EXPECT_TRUE(Ends({}, Vertical(kStraightLeft_m, {0.1, 0.08, 0.1})).concave_edge);
}

TEST(FindBending, ConvexAndStraightEdgesAreNoEvidence) {
  EXPECT_FALSE(Ends(Horizontal({-0.1, -0.13, -0.1}, {0.1, 0.13, 0.1})).concave_edge);
  EXPECT_FALSE(Ends(Horizontal({-0.1, -0.12, -0.14}, kStraightRight_m)).concave_edge);
}

TEST(FindBending, TheDepthIsTheLeftSideOfEquation5_3) {
  EXPECT_NEAR(Ends(Horizontal({-0.12, -0.08, -0.10}, kStraightRight_m)).concave_edge_m,
              -0.08 + 0.5 * (0.12 + 0.10), 1e-12);
}

TEST(FindBending, UnequalStepsAlongAStraightSlantedEdgeAreNoEvidence) {
  auto ends = Horizontal({-0.10, -0.02, 0.0}, kStraightRight_m);
  ends[0].first_B_m.y() = -0.10;
  ends[1].first_B_m.y() = -0.02;
  ends[2].first_B_m.y() = 0.0;
  EXPECT_FALSE(Ends(ends).concave_edge);
}

TEST(FindBending, AStraightEdgeInDepthIsNoEvidence) {
  auto ends = Horizontal({0, 0, 0}, kStraightRight_m);
  for (size_t i = 0; i < 3; ++i) {
    const double t = static_cast<double>(i) * 0.5;
    ends[i].first_B_m = Eigen::Vector3d(-0.2, -0.1, 1.0) + t * Eigen::Vector3d(0.1, 0.15, 0.6);
  }
  EXPECT_NEAR(Ends(ends).concave_edge_m, 0.0, 1e-12);
}

TEST(FindBending, TheToleranceGrowsWithTheSpanOfTheStripes) {
  BendingOptions options;
  options.concave_edge_m = 0.005;
  const auto ends = Horizontal({-0.1, -0.09, -0.1}, kStraightRight_m);  // 10 mm in a span of 0.1 m
  EXPECT_TRUE(FindBending({}, ends, {}, options).concave_edge);
  options.concave_edge_1 = 0.06;
  EXPECT_FALSE(FindBending({}, ends, {}, options).concave_edge);
  EXPECT_NEAR(FindBending({}, ends, {}, options).concave_edge_m, 0.010, 1e-9);
}

TEST(FindBending, TwoStripesAreNotEnough) {
  auto ends = Horizontal({-0.1, -0.05, -0.1}, kStraightRight_m);
  ends.pop_back();
  EXPECT_FALSE(Ends(ends).found());
}

TEST(FindBending, RefusesAToleranceOfNothing) {
  BendingOptions options;
  options.concave_edge_m = 0.0;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
