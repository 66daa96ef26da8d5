#include "sim/checks.h"

#include <algorithm>
#include <cmath>

namespace geon::sim {
namespace {

using Eigen::Vector2d;

// A stretch of one axis, in squares: how much of it lies on the board, and how much more of that on
// even squares than on odd ones; both as shares of the stretch.
struct Stretch {
  double board_1, even_1;
};
Stretch Measure(double middle, double length, int squares) {
  // Even less odd squares from 0 to x, for x on the board.
  const auto even_to = [](double x) {
    const double whole = std::floor(x);
    return std::fmod(whole, 2.0) == 0.0 ? x - whole : 1.0 - (x - whole);
  };
  const double from = std::clamp(middle - 0.5 * length, 0.0, static_cast<double>(squares));
  const double to = std::clamp(middle + 0.5 * length, 0.0, static_cast<double>(squares));
  return {(to - from) / length, (even_to(to) - even_to(from)) / length};
}

}  // namespace

float PaintLeft(const Checks& checks, const Eigen::Vector3f& p_W_m, const Eigen::Vector3f& step_u_m,
                const Eigen::Vector3f& step_v_m) {
  const auto in_squares = [&](const Eigen::Vector3d& step_m) {
    return Vector2d(checks.along_W.dot(step_m) / checks.square_m,
                    checks.up_W.dot(step_m) / checks.square_m);
  };
  const Vector2d middle = in_squares(p_W_m.cast<double>() - checks.corner_W_m);
  const Vector2d step_u = in_squares(step_u_m.cast<double>()),
                 step_v = in_squares(step_v_m.cast<double>());
  // The parallelogram is cut into nine, each taken as the upright rectangle that holds it: that is
  // symmetric, so that edges and corners stay where they are, and nearly as sharp.
  constexpr int kParts = 3;
  const Vector2d whole = (step_u.cwiseAbs() + step_v.cwiseAbs()).cwiseMax(1e-6);
  const auto dark_1 = [&](const Vector2d& at, const Vector2d& side) {
    const Stretch along = Measure(at.x(), side.x(), checks.columns);
    const Stretch up = Measure(at.y(), side.y(), checks.rows);
    return 0.5 * (along.board_1 * up.board_1 + along.even_1 * up.even_1);
  };
  const Vector2d low = middle - 0.5 * whole, high = middle + 0.5 * whole;
  double dark = 0.0;
  if (std::floor(low.x()) == std::floor(high.x()) && std::floor(low.y()) == std::floor(high.y())) {
    dark = dark_1(middle, whole);  // within one square, or beside all
  } else {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        dark +=
            dark_1(middle + (i * step_u + j * step_v) / kParts, whole / kParts) / (kParts * kParts);
      }
    }
  }
  return static_cast<float>(1.0 - (1.0 - checks.ink_1) * dark);
}

}  // namespace geon::sim
