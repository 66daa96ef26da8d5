#include "recognition/polyline_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/contracts.h"
#include "tests/common/recognition/analytic_curves.h"

namespace geon::recognition {
namespace {

constexpr int kPolylineSamples = 81;
constexpr double kTolerance_m = 0.003;

using Vertices = std::vector<int> (*)(std::span<const Eigen::Vector2d>, double);

// Both methods on the same curves.
class PolylineFit : public testing::TestWithParam<Vertices> {
 protected:
  static std::vector<int> Fit(const std::vector<Eigen::Vector2d>& curve_m,
                              double tolerance_m = kTolerance_m) {
    return GetParam()(curve_m, tolerance_m);
  }
  static CurveFeatures FeaturesOf(const std::vector<Eigen::Vector2d>& curve_m) {
    return FindFeatures(curve_m, Fit(curve_m), {});
  }
};

TEST_P(PolylineFit, ALineIsOnePiece) {
  EXPECT_EQ(Fit(PolylineCurve(0.2, {}, kPolylineSamples)),
            (std::vector<int>{0, kPolylineSamples - 1}));
}

TEST_P(PolylineFit, PutsAVertexAtACorner) {
  const auto vertices = Fit(PolylineCurve(0.1, {1.2}, kPolylineSamples));
  ASSERT_GE(vertices.size(), 3U);
  const bool near_corner = std::any_of(vertices.begin(), vertices.end(), [](int v) {
    return std::abs(v - kPolylineSamples / 2) <= 4;
  });
  EXPECT_TRUE(near_corner);
}

TEST_P(PolylineFit, FollowsAnArcMoreCloselyWithASmallerTolerance) {
  const auto arc_m = ArcCurve(0.1, 2.0, kPolylineSamples);
  const auto coarse = Fit(arc_m, 0.006);
  const auto fine = Fit(arc_m, 0.0005);
  EXPECT_GT(coarse.size(), 2U);
  EXPECT_GT(fine.size(), coarse.size());
}

TEST_P(PolylineFit, VerticesAscendFromFirstToLast) {
  auto curve_m = ArcCurve(0.1, 2.0, kPolylineSamples);
  AddNoise(0.001, 3, &curve_m);
  const auto vertices = Fit(curve_m);
  EXPECT_EQ(vertices.front(), 0);
  EXPECT_EQ(vertices.back(), kPolylineSamples - 1);
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
  EXPECT_EQ(std::adjacent_find(vertices.begin(), vertices.end()), vertices.end());
}

TEST_P(PolylineFit, ReadsCurveCornerAndConcavity) {
  EXPECT_EQ(FeaturesOf(PolylineCurve(0.2, {}, kPolylineSamples)).curves, 0);
  EXPECT_EQ(FeaturesOf(PolylineCurve(0.2, {}, kPolylineSamples)).corners, 0);
  EXPECT_EQ(FeaturesOf(ArcCurve(0.1, 2.5, kPolylineSamples)).curves, 1);
  EXPECT_EQ(FeaturesOf(ArcCurve(0.1, 2.5, kPolylineSamples)).concavities, 0);
  EXPECT_GE(FeaturesOf(ArcCurve(0.1, -2.5, kPolylineSamples)).concavities, 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, PolylineFit, testing::Values(&RamerVertices, &WallVertices));

TEST(RamerVertices, NoPointIsFartherThanTheTolerance) {
  const auto arc_m = ArcCurve(0.1, 2.0, kPolylineSamples);
  const auto vertices = RamerVertices(arc_m, kTolerance_m);
  for (size_t k = 0; k + 1 < vertices.size(); ++k) {
    const Eigen::Vector2d a = arc_m[static_cast<size_t>(vertices[k])];
    const Eigen::Vector2d chord = (arc_m[static_cast<size_t>(vertices[k + 1])] - a).normalized();
    for (int i = vertices[k]; i <= vertices[k + 1]; ++i) {
      const Eigen::Vector2d d = arc_m[static_cast<size_t>(i)] - a;
      EXPECT_LE(std::abs(chord.x() * d.y() - chord.y() * d.x()), kTolerance_m + 1e-12);
    }
  }
}

TEST(RamerVertices, FindsACornerExactly) {
  EXPECT_EQ(RamerVertices(PolylineCurve(0.1, {1.2}, kPolylineSamples), kTolerance_m),
            (std::vector<int>{0, kPolylineSamples / 2, kPolylineSamples - 1}));
}

TEST(VertexTurns, ArePositiveClockwise) {
  const std::vector<Eigen::Vector2d> curve = {{0, 0}, {1, 0}, {1, -1}, {2, -1}};
  const std::vector<int> all = {0, 1, 2, 3};
  const auto turn_rad = VertexTurns(curve, all);
  ASSERT_EQ(turn_rad.size(), 2U);
  EXPECT_NEAR(turn_rad[0], 0.5 * kPi, 1e-12);
  EXPECT_NEAR(turn_rad[1], -0.5 * kPi, 1e-12);
}

TEST(PolylineFeatures, ASharpTurnBetweenLongPiecesIsACorner) {
  const auto curve_m = PolylineCurve(0.1, {1.2}, kPolylineSamples);
  const CurveFeatures features = FindFeatures(curve_m, RamerVertices(curve_m, kTolerance_m), {});
  EXPECT_EQ(features.corners, 1);
  EXPECT_EQ(features.curves, 0);
}

TEST(PolylineOptions, RefusesAToleranceOfNothing) {
  PolylineOptions options;
  options.tolerance_m = 0.0;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
