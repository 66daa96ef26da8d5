#include "calibration/find_board.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geon::calibration {
namespace {

// A board drawn through a homography, each pixel the mean of 8 x 8 samples, with noise.
struct DrawnBoard {
  Eigen::Matrix3d pixel_from_square;
  int columns = 10, rows = 7;  // inner corners

  // Of the paper: 1 white, 0 black, 0.5 outside.
  double Shade(double x, double y) const {
    if (x < -1.0 || y < -1.0 || x >= columns || y >= rows) return 0.5;
    return (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 == 0 ? 1.0 : 0.0;
  }
  sensor::Image Picture(double black, double white, double noise, uint64_t seed) const {
    sensor::Image image;
    image.width_px = 640;
    image.height_px = 480;
    image.row_stride_bytes = 640;
    image.data.resize(640 * 480);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(0.0, noise);
    const Eigen::Matrix3d back = pixel_from_square.inverse();
    constexpr int kSamples = 8;
    for (int v = 0; v < 480; ++v) {
      for (int u = 0; u < 640; ++u) {
        double sum = 0.0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const Eigen::Vector3d p =
              back * Eigen::Vector3d(u - 0.5 + (i % kSamples + 0.5) / kSamples,
                                     v - 0.5 + (i / kSamples + 0.5) / kSamples, 1.0);
          sum += Shade(p.x() / p.z(), p.y() / p.z());
        }
        const double level = black + (white - black) * sum / (kSamples * kSamples) + gauss(random);
        image.data[static_cast<size_t>(v) * 640 + static_cast<size_t>(u)] =
            static_cast<uint8_t>(std::clamp(std::lround(level), 0L, 255L));
      }
    }
    return image;
  }
  Eigen::Vector2d Corner(int k) const {
    const Eigen::Vector3d p = pixel_from_square * Eigen::Vector3d(k % columns, k / columns, 1.0);
    return p.head<2>() / p.z();
  }
};

DrawnBoard Slanting(double left_px) {
  DrawnBoard board;
  board.pixel_from_square << 26.3, -2.1, left_px, 1.7, 27.9, 140.6, 0.004, 0.002, 1.0;
  return board;
}

double Rms(const DrawnBoard& drawn, const BoardSighting& sighting) {
  double sum = 0.0;
  for (int k = 0; k < 70; ++k) {
    sum += (sighting.corners_px[static_cast<size_t>(k)] - drawn.Corner(k)).squaredNorm() / 2;
  }
  return std::sqrt(sum / 70);
}

TEST(FindBoard, MeasuresCornersToAFewHundredthsOfAPixel) {
  for (const double left_px : {190.2, 201.7, 214.4}) {
    const DrawnBoard drawn = Slanting(left_px);
    const auto sighting = FindBoard(drawn.Picture(20, 220, 2.0, 1), Chessboard{});
    ASSERT_TRUE(sighting);
    EXPECT_LT(Rms(drawn, *sighting), 0.03) << left_px;
    EXPECT_TRUE(sighting->first_square_white);
  }
}

TEST(FindBoard, SeesABoardInTheFewGreyLevelsOfAFilteredCamera) {
  const DrawnBoard drawn = Slanting(200.0);
  const auto sighting = FindBoard(drawn.Picture(6, 40, 1.2, 2), Chessboard{});
  ASSERT_TRUE(sighting);
  EXPECT_LT(Rms(drawn, *sighting), 0.08);
}

TEST(FindBoard, SkipsABoardThatIsNotWholeOrHasOtherSquares) {
  EXPECT_FALSE(FindBoard(Slanting(-60.0).Picture(20, 220, 2.0, 3), Chessboard{}));
  EXPECT_FALSE(FindBoard(Slanting(200.0).Picture(20, 220, 2.0, 3), Chessboard{9, 7, 0.02}));
  DrawnBoard empty = Slanting(200.0);
  EXPECT_FALSE(FindBoard(empty.Picture(128, 128, 2.0, 3), Chessboard{}));
}

// A stripe, 3 px wide, along v = 228 + 0.03 u (or the same with u and v exchanged), dim on black.
sensor::Image Stripe(const DrawnBoard& board, bool vertical) {
  sensor::Image image = board.Picture(0, 0, 0, 1);
  const Eigen::Matrix3d back = board.pixel_from_square.inverse();
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const double off = vertical ? u - 320.0 - 0.02 * v : v - 228.15 - 0.03 * u;
      const Eigen::Vector3d p = back * Eigen::Vector3d(u, v, 1.0);
      const double shade = 0.05 + 0.95 * board.Shade(p.x() / p.z(), p.y() / p.z());
      image.data[static_cast<size_t>(v) * 640 + static_cast<size_t>(u)] =
          static_cast<uint8_t>(std::lround(200.0 * shade * std::exp(-0.5 * off * off / 1.5)));
    }
  }
  return image;
}

TEST(FindStripeOnBoard, KeepsToTheMiddleOfWhiteSquares) {
  const DrawnBoard board = Slanting(200.0);
  const auto sighting = FindBoard(board.Picture(20, 220, 2.0, 1), Chessboard{});
  ASSERT_TRUE(sighting);
  const BoardStripe stripe =
      FindStripeOnBoard(Stripe(board, false), sensor::Laser::kHorizontal, Chessboard{}, *sighting);
  EXPECT_FALSE(stripe.other_way);
  EXPECT_GT(stripe.points_px.size(), 40U);
  EXPECT_LT(stripe.points_px.size(), 170U);
  const Eigen::Matrix3d back = board.pixel_from_square.inverse();
  for (const Eigen::Vector2d& point_px : stripe.points_px) {
    EXPECT_NEAR(point_px.y(), 228.15 + 0.03 * point_px.x(), 0.1);
    const Eigen::Vector3d p = back * point_px.homogeneous();
    EXPECT_EQ(board.Shade(p.x() / p.z(), p.y() / p.z()), 1.0);
  }
}

TEST(FindStripeOnBoard, TellsTheOtherLaser) {
  const DrawnBoard board = Slanting(200.0);
  const auto sighting = FindBoard(board.Picture(20, 220, 2.0, 1), Chessboard{});
  ASSERT_TRUE(sighting);
  const sensor::Image light = Stripe(board, true);
  EXPECT_TRUE(
      FindStripeOnBoard(light, sensor::Laser::kHorizontal, Chessboard{}, *sighting).other_way);
  EXPECT_FALSE(
      FindStripeOnBoard(light, sensor::Laser::kVertical, Chessboard{}, *sighting).other_way);
}

}  // namespace
}  // namespace geon::calibration
