#include "sim/checks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::sim {
namespace {

using Eigen::Vector3f;

// 5 x 3 squares of 0.1 m in the plane z = 2, the lower left corner at (1, 1).
Checks TestChecks() {
  Checks checks;
  checks.corner_W_m = {1.0, 1.0, 2.0};
  checks.columns = 5;
  checks.rows = 3;
  checks.square_m = 0.1;
  checks.ink_1 = 0.1;
  return checks;
}

float PaintLeftAt(float x_m, float y_m, const Vector3f& step_u_m, const Vector3f& step_v_m) {
  return PaintLeft(TestChecks(), {x_m, y_m, 2.0F}, step_u_m, step_v_m);
}

// What a point sees.
double PointLeft(double x_m, double y_m) {
  const double column = std::floor((x_m - 1.0) / 0.1), row = std::floor((y_m - 1.0) / 0.1);
  const bool on_board = column >= 0 && column < 5 && row >= 0 && row < 3;
  return on_board && std::fmod(column + row, 2.0) == 0.0 ? 0.1 : 1.0;
}

const Vector3f kSmallU(0.01F, 0, 0), kSmallV(0, 0.01F, 0);

TEST(ChecksTest, SquaresAlternateFromADarkCornerAndEndAtTheRim) {
  EXPECT_NEAR(PaintLeftAt(1.05F, 1.05F, kSmallU, kSmallV), 0.1, 1e-6);
  EXPECT_NEAR(PaintLeftAt(1.15F, 1.05F, kSmallU, kSmallV), 1.0, 1e-6);
  EXPECT_NEAR(PaintLeftAt(1.15F, 1.15F, kSmallU, kSmallV), 0.1, 1e-6);
  EXPECT_NEAR(PaintLeftAt(1.45F, 1.25F, kSmallU, kSmallV), 0.1, 1e-6);
  EXPECT_NEAR(PaintLeftAt(1.55F, 1.25F, kSmallU, kSmallV), 1.0, 1e-6);
  EXPECT_NEAR(PaintLeftAt(0.95F, 1.05F, kSmallU, kSmallV), 1.0, 1e-6);
}

TEST(ChecksTest, APixelOnAnEdgeSeesItsShareOfBothSquares) {
  for (const float share_1 : {0.1F, 0.3F, 0.5F, 0.9F}) {  // of the pixel, on the dark square
    const float x_m = 1.1F + 0.01F * (0.5F - share_1);
    EXPECT_NEAR(PaintLeftAt(x_m, 1.05F, kSmallU, kSmallV), 1.0F - 0.9F * share_1, 1e-4);
  }
  EXPECT_NEAR(PaintLeftAt(1.1F, 1.1F, kSmallU, kSmallV), 0.55, 1e-4);  // where four meet
}

TEST(ChecksTest, SlantedPixelsSeeNearlyTheirMeanAndAsMuchOnEitherSideOfAnEdge) {
  const Vector3f step_u_m(0.012F, 0.006F, 0), step_v_m(-0.004F, 0.009F, 0);
  for (const auto& [x_m, y_m] :
       {std::pair{1.101F, 1.05F}, {1.1F, 1.1F}, {1.197F, 1.203F}, {1.5F, 1.25F}, {1.2F, 0.999F}}) {
    double mean = 0.0;
    constexpr int kSide = 100;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const float a = (static_cast<float>(i) + 0.5F) / kSide - 0.5F,
                    b = (static_cast<float>(j) + 0.5F) / kSide - 0.5F;
        const Vector3f p = Vector3f(x_m, y_m, 2.0F) + a * step_u_m + b * step_v_m;
        mean += PointLeft(static_cast<double>(p.x()), static_cast<double>(p.y())) / kSide / kSide;
      }
    }
    EXPECT_NEAR(PaintLeftAt(x_m, y_m, step_u_m, step_v_m), mean, 0.03) << x_m << " " << y_m;
  }
  // Equally far on either side of an edge: what one lacks the other has.
  for (const float d_m : {0.001F, 0.003F, 0.006F}) {
    EXPECT_NEAR(PaintLeftAt(1.1F + d_m, 1.05F, step_u_m, step_v_m) +
                    PaintLeftAt(1.1F - d_m, 1.05F, step_u_m, step_v_m),
                1.1, 1e-4);
  }
}

}  // namespace
}  // namespace geon::sim
