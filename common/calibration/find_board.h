#pragma once

#include <optional>
#include <vector>

#include "calibration/rig_observations.h"
#include "rangefinder/stripe_peaks.h"
#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::calibration {

// The whole chessboard in one picture.
struct BoardSighting {
  std::vector<Eigen::Vector2d> corners_px;  // in the order of Chessboard
  bool first_square_white = true;           // the one right of and below the first corner
};

// Finds the board's inner corners to a few hundredths of a pixel; nothing when not all are there,
// or one is too near the picture's border to be measured.
//
// Source: OpenCV's findChessboardCorners, then cornerSubPix (Forstner & Gulch 1987) on the slightly
// blurred picture in a window that holds one corner only: 0.02 px rms on drawn boards, where
// without the blur it is 0.05 px, and so with findChessboardCornersSB. The board is taken to stand
// upright: its columns run to the right. Input: kGray8, kRgb8 or kBgr8.
std::optional<BoardSighting> FindBoard(const sensor::Image& image, const Chessboard& board);

// What a laser left on a board that was seen at the same head pose.
struct BoardStripe {
  std::vector<Eigen::Vector2d> points_px;  // (u, v), on white squares and away from their edges
  // The light runs the other way: it is the other laser's stripe.
  bool other_way = false;
};
BoardStripe FindStripeOnBoard(const sensor::Image& laser_light, sensor::Laser laser,
                              const Chessboard& board, const BoardSighting& sighting,
                              const rangefinder::PeakOptions& options = {});

// All points of a stripe, as for a bare floor.
std::vector<Eigen::Vector2d> StripePoints(const sensor::Image& laser_light, sensor::Laser laser,
                                          const rangefinder::PeakOptions& options = {});

}  // namespace geon::calibration
