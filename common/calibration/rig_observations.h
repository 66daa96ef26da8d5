#pragma once

#include <Eigen/Core>
#include <vector>

#include "sensor/image.h"

namespace geon::calibration {

// The chessboard: how many inner corners it has and how large its squares are.
struct Chessboard {
  int columns = 10;  // inner corners along the longer side, 3 or more
  int rows = 7;
  double square_m = 0.02;

  int corners() const { return columns * rows; }
  // Of corner `index`, row by row from the top left, in the board's frame: x to the right, y down,
  // z away from the viewer, origin in the first corner.
  Eigen::Vector3d Corner(int index) const {
    const int row = index / columns;
    return {square_m * (index % columns), square_m * row, 0.0};
  }
};

// What one head pose saw of the board. A picture that does not show the whole board has no corners.
struct BoardView {
  int stop = 0;  // views of one stop share where the robot and the board stand
  double pan_rad = 0.0, tilt_rad = 0.0;  // by the unit's encoders
  std::vector<Eigen::Vector2d>
      color_corners_px;  // all corners, in the order of Chessboard, or none
  std::vector<Eigen::Vector2d> stripe_corners_px;  // the same in the B/W picture
  std::vector<Eigen::Vector2d> horizontal_px;      // (u, v) of the stripe's centre on white squares
  std::vector<Eigen::Vector2d> vertical_px;
};

// A horizontal stripe on the bare floor.
struct FloorView {
  double pan_rad = 0.0, tilt_rad = 0.0;
  std::vector<Eigen::Vector2d> horizontal_px;
};

struct RigObservations {
  Chessboard board;
  std::vector<BoardView> views;
  std::vector<FloorView> floor;  // may be empty: then where the head stands stays as drawn
};

}  // namespace geon::calibration
