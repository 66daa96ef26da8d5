#include "recognition/straight_pieces.h"

#include <array>
#include <limits>

#include "recognition/line_moments.h"

namespace geon::recognition {
namespace {

constexpr size_t kBreaks = 24;
constexpr double kStraightTolerance_1 = 0.003;  // of the stripe's length
constexpr size_t kFewestOfStripe = 8;

// The inner breaks of the best fit by 1, 2 or 3 lines, and its sum of squares.
struct Fit {
  double squares = std::numeric_limits<double>::infinity();
  std::array<size_t, 2> breaks{};  // as many as it has lines, less one
};

std::array<Fit, 3> BestFits(const std::vector<Eigen::Vector2d>& curve_m) {
  const size_t n = curve_m.size();
  std::array<size_t, kBreaks + 1> place{};
  std::array<LineMoments, kBreaks + 1> until;
  for (size_t k = 1; k <= kBreaks; ++k) {
    place[k] = k * n / kBreaks;
    until[k] = until[k - 1];
    for (size_t i = place[k - 1]; i < place[k]; ++i) until[k].Add(curve_m[i] - curve_m[0]);
  }
  std::array<double, kBreaks + 1> before{}, after{};
  for (size_t k = 0; k <= kBreaks; ++k) {
    before[k] = until[k].LineResidual();
    after[k] = (until[kBreaks] - until[k]).LineResidual();
  }
  std::array<Fit, 3> best;
  best[0].squares = before[kBreaks];
  for (size_t i = 1; i < kBreaks; ++i) {
    if (before[i] + after[i] < best[1].squares) best[1] = {before[i] + after[i], {place[i]}};
    for (size_t j = i + 1; j < kBreaks; ++j) {
      if (before[i] + after[j] >= best[2].squares) continue;
      const double squares = before[i] + (until[j] - until[i]).LineResidual() + after[j];
      if (squares < best[2].squares) best[2] = {squares, {place[i], place[j]}};
    }
  }
  return best;
}

Eigen::Vector3d Direction(const TargetStripe& stripe, size_t begin, size_t end) {
  const size_t third = std::max<size_t>((end - begin) / 3, 1);
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), last = first;
  for (size_t i = 0; i < third; ++i) {
    first += stripe.p_L_m[begin + i];
    last += stripe.p_L_m[end - 1 - i];
  }
  return (last - first).normalized();
}

}  // namespace

std::vector<StraightPiece> FindStraightPieces(const TargetStripe& stripe) {
  const size_t n = stripe.curve_m.size();
  if (n < kFewestOfStripe) return {};
  const std::array<Fit, 3> fits = BestFits(stripe.curve_m);
  const double length_m = (stripe.curve_m.back() - stripe.curve_m.front()).norm();
  const double tolerance_m = std::max(stripe.noise_m, kStraightTolerance_1 * length_m);
  const double enough = tolerance_m * tolerance_m * static_cast<double>(n);
  size_t lines = 0;
  while (lines < 2 && fits[lines].squares > enough) ++lines;
  std::vector<StraightPiece> pieces;
  size_t begin = 0;
  for (size_t line = 0; line <= lines; ++line) {
    const size_t end = line < lines ? fits[lines].breaks[line] : n;
    if (end < begin + 2) continue;
    pieces.push_back({begin, end, Direction(stripe, begin, end)});
    begin = end;
  }
  return pieces;
}

}  // namespace geon::recognition
