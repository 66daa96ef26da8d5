#pragma once

#include <Eigen/Core>

namespace geon::sim {

// Dark squares on a flat board, as on a chessboard: the one at the corner is dark. Frame W.
struct Checks {
  Eigen::Vector3d corner_W_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_W = Eigen::Vector3d::UnitX();  // unit: the sides of the squares
  Eigen::Vector3d up_W = Eigen::Vector3d::UnitY();
  int columns = 0;  // squares along `along_W`
  int rows = 0;
  double square_m = 0.03;
  double ink_1 = 0.06;  // how much light a dark square leaves of the paint's
};

// What the ink leaves of the paint's light (1: all), averaged over what a pixel sees of the board:
// the parallelogram about `p_W_m` with the sides `step_u_m` and `step_v_m`.
float PaintLeft(const Checks& checks, const Eigen::Vector3f& p_W_m, const Eigen::Vector3f& step_u_m,
                const Eigen::Vector3f& step_v_m);

}  // namespace geon::sim
