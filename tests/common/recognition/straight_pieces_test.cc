#include "recognition/straight_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/common/recognition/surface_view.h"

namespace geon::recognition {
namespace {

TargetStripe Middle(const std::function<double(double, double)>& height_m) {
  return ViewOfSurface(height_m).stripes[1];
}

TEST(StraightPieces, ALineIsOnePieceEvenWithNoise) {
  TargetStripe stripe = Middle([](double y_m, double) { return 0.3 * y_m; });
  EXPECT_EQ(FindStraightPieces(stripe).size(), 1U);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise_m(0.0, 0.001);
  for (Eigen::Vector2d& p_m : stripe.curve_m) p_m.y() += noise_m(random);
  stripe.noise_m = 0.0012;
  EXPECT_EQ(FindStraightPieces(stripe).size(), 1U);
}

TEST(StraightPieces, ACornerIsTwoAndTheyLieOnItsFaces) {
  const auto pieces =
      FindStraightPieces(Middle([](double y_m, double) { return -std::abs(y_m - 0.02); }));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(static_cast<double>(pieces[0].end), 80.0, 7.0);
  EXPECT_NEAR(pieces[0].direction_L.x() / pieces[0].direction_L.y(), 1.0, 0.05);
  EXPECT_NEAR(pieces[1].direction_L.x() / pieces[1].direction_L.y(), -1.0, 0.05);
}

TEST(StraightPieces, AnArcIsThreeAndCoversTheStripe) {
  const auto pieces =
      FindStraightPieces(Middle([](double y_m, double) { return std::sqrt(0.0144 - y_m * y_m); }));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces.front().begin, 0U);
  EXPECT_EQ(pieces.back().end, 201U);
  for (size_t k = 1; k < 3; ++k) EXPECT_EQ(pieces[k].begin, pieces[k - 1].end);
}

TEST(StraightPieces, AnEmptyStripeHasNone) { EXPECT_TRUE(FindStraightPieces({}).empty()); }

}  // namespace
}  // namespace geon::recognition
