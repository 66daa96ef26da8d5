#include "calibration/find_board.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "base/contracts.h"

namespace geon::calibration {
namespace {

using sensor::Laser;
using sensor::PixelFormat;

cv::Mat Gray(const sensor::Image& image) {
  Require(ChannelCount(image.format) > 0, "FindBoard: the picture is compressed");
  // OpenCV reads it only.
  const cv::Mat pixels(
      image.height_px, image.width_px, ChannelCount(image.format) == 1 ? CV_8UC1 : CV_8UC3,
      const_cast<uint8_t*>(image.data.data()), static_cast<size_t>(image.row_stride_bytes));
  cv::Mat gray;
  switch (image.format) {
    case PixelFormat::kBgr8:
      cv::cvtColor(pixels, gray, cv::COLOR_BGR2GRAY);
      break;
    case PixelFormat::kRgb8:
      cv::cvtColor(pixels, gray, cv::COLOR_RGB2GRAY);
      break;
    default:
      gray = pixels.clone();
      break;
  }
  return gray;
}

// A filtered camera sees the board in few grey levels: they are spread over all.
cv::Mat Stretched(const cv::Mat& gray) {
  cv::Mat stretched;
  cv::normalize(gray, stretched, 0, 255, cv::NORM_MINMAX);
  return stretched;
}

double SmallestSpacing_px(const std::vector<cv::Point2f>& corners, const Chessboard& board) {
  double smallest_px = 1e9;
  for (int k = 0; k < board.corners(); ++k) {
    const auto to = [&](int other) {
      smallest_px = std::min(smallest_px, cv::norm(corners[static_cast<size_t>(k)] -
                                                   corners[static_cast<size_t>(other)]));
    };
    if (k % board.columns > 0) to(k - 1);
    if (k >= board.columns) to(k - board.columns);
  }
  return smallest_px;
}

// Mean brightness of the squares of both colours, told by their middles: even, odd.
bool FirstSquareWhite(const cv::Mat& gray, const std::vector<cv::Point2f>& corners,
                      const Chessboard& board) {
  double sum[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (int row = 0; row + 1 < board.rows; ++row) {
    for (int column = 0; column + 1 < board.columns; ++column) {
      const auto k = static_cast<size_t>(row * board.columns + column);
      const auto below = k + static_cast<size_t>(board.columns);
      const cv::Point2f middle =
          0.25F * (corners[k] + corners[k + 1] + corners[below] + corners[below + 1]);
      const int colour = (row + column) % 2;
      sum[colour] += gray.at<uint8_t>(cv::Point(cvRound(middle.x), cvRound(middle.y)));
      ++count[colour];
    }
  }
  return sum[0] / count[0] > sum[1] / count[1];
}

Laser Other(Laser laser) {
  return laser == Laser::kVertical ? Laser::kHorizontal : Laser::kVertical;
}

}  // namespace

std::optional<BoardSighting> FindBoard(const sensor::Image& image, const Chessboard& board) {
  Require(board.columns >= 3 && board.rows >= 3, "FindBoard: a board has 3 x 3 corners or more");
  const cv::Mat gray = Gray(image);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(Stretched(gray), {board.columns, board.rows}, corners,
                                 cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_FAST_CHECK)) {
    return std::nullopt;
  }
  constexpr double kBorder_px = 8.0;
  for (const cv::Point2f& corner : corners) {
    if (corner.x < kBorder_px || corner.x > gray.cols - 1 - kBorder_px || corner.y < kBorder_px ||
        corner.y > gray.rows - 1 - kBorder_px) {
      return std::nullopt;
    }
  }
  // Half a window holds no second corner, even of a board seen slanting.
  const int half_px = std::clamp(static_cast<int>(0.4 * SmallestSpacing_px(corners, board)), 2, 7);
  // A little blur halves the error that the interpolation between sharp pixels makes.
  cv::Mat smooth;
  gray.convertTo(smooth, CV_32F);
  cv::GaussianBlur(smooth, smooth, {0, 0}, 1.0);
  cv::cornerSubPix(smooth, corners, {half_px, half_px}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 50, 1e-4});
  if (corners[1].x < corners[0].x) std::reverse(corners.begin(), corners.end());

  BoardSighting sighting;
  for (const cv::Point2f& corner : corners) sighting.corners_px.emplace_back(corner.x, corner.y);
  sighting.first_square_white = FirstSquareWhite(gray, corners, board);
  return sighting;
}

std::vector<Eigen::Vector2d> StripePoints(const sensor::Image& laser_light, Laser laser,
                                          const rangefinder::PeakOptions& options) {
  std::vector<Eigen::Vector2d> points_px;
  for (const rangefinder::StripePeak& peak : FindStripePeaks(laser_light, laser, options)) {
    if (peak.reason != rangefinder::PeakReason::kFound) continue;
    if (laser == Laser::kVertical) {
      points_px.emplace_back(peak.position_px, peak.pixel);
    } else {
      points_px.emplace_back(peak.pixel, peak.position_px);
    }
  }
  return points_px;
}

BoardStripe FindStripeOnBoard(const sensor::Image& laser_light, Laser laser,
                              const Chessboard& board, const BoardSighting& sighting,
                              const rangefinder::PeakOptions& options) {
  const std::vector<Eigen::Vector2d> all_px = StripePoints(laser_light, laser, options);
  BoardStripe stripe;
  stripe.other_way = StripePoints(laser_light, Other(laser), options).size() > 2 * all_px.size();
  if (stripe.other_way || all_px.empty()) return stripe;

  std::vector<cv::Point2d> corners;
  std::vector<cv::Point2d> squares;  // counted in squares from the first corner
  for (int k = 0; k < board.corners(); ++k) {
    const Eigen::Vector2d& corner_px = sighting.corners_px[static_cast<size_t>(k)];
    corners.emplace_back(corner_px.x(), corner_px.y());
    squares.emplace_back(k % board.columns, k / board.columns);
  }
  const cv::Matx33d to_squares = cv::findHomography(corners, squares);
  constexpr double kMargin_1 = 0.2;  // of a square: more than the stripe is thick
  for (const Eigen::Vector2d& point_px : all_px) {
    const cv::Vec3d p = to_squares * cv::Vec3d(point_px.x(), point_px.y(), 1.0);
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    const auto column = static_cast<int>(std::floor(x));
    const auto row = static_cast<int>(std::floor(y));
    if (column < -1 || row < -1 || column >= board.columns || row >= board.rows) continue;
    const bool white = ((column + row) % 2 == 0) == sighting.first_square_white;
    const auto inside = [&](double share) { return share > kMargin_1 && share < 1.0 - kMargin_1; };
    if (white && inside(x - column) && inside(y - row)) stripe.points_px.push_back(point_px);
  }
  return stripe;
}

}  // namespace geon::calibration
