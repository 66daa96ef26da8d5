#include "recognition/find_tapering.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

double InMetres(const TaperingTolerance& tolerance, std::span<const ProfileEnds> ends) {
  double sum_m = 0.0;
  for (const ProfileEnds& e : ends) sum_m += e.length_m;
  const double mean_m = ends.empty() ? 0.0 : sum_m / static_cast<double>(ends.size());
  return tolerance.absolute_m + tolerance.relative_1 * mean_m;
}

// (5.4-5.7): strictly rising or strictly falling, every step above the tolerance.
bool IsMonotone(std::span<const ProfileEnds> ends, double tolerance_m) {
  if (ends.size() < 3) return false;
  int rising = 0;
  int falling = 0;
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    const double step_m = ends[i + 1].length_m - ends[i].length_m;
    if (step_m > tolerance_m) ++rising;
    if (step_m < -tolerance_m) ++falling;
  }
  const int steps = static_cast<int>(ends.size()) - 1;
  return rising == steps || falling == steps;
}

// The left side of (5.8); `across` is 0 for horizontal stripes (x), 1 for vertical ones (y).
double Asymmetry(std::span<const ProfileEnds> ends, int across) {
  double largest_m = 0.0;
  for (size_t i = 0; i + 2 < ends.size(); ++i) {
    const auto step_m = [&](size_t j, bool first) {
      const Eigen::Vector3d& a = first ? ends[j].first_B_m : ends[j].last_B_m;
      const Eigen::Vector3d& b = first ? ends[j + 1].first_B_m : ends[j + 1].last_B_m;
      return std::abs(b[across] - a[across]);
    };
    const double left_m = std::abs(step_m(i, true) - step_m(i + 1, true));
    const double right_m = std::abs(step_m(i, false) - step_m(i + 1, false));
    largest_m = std::max(largest_m, std::abs(left_m - right_m));
  }
  return largest_m;
}

}  // namespace

void TaperingOptions::Validate() const {
  const auto check = [](const TaperingTolerance& tolerance, const char* name) {
    Require(tolerance.absolute_m >= 0.0, name, tolerance.absolute_m, "must not be negative");
    Require(tolerance.relative_1 >= 0.0, name, tolerance.relative_1, "must not be negative");
  };
  check(horizontal_length, "horizontal_length");
  check(vertical_length, "vertical_length");
  check(horizontal_step, "horizontal_step");
  check(vertical_step, "vertical_step");
}

sensor::TaperingEvidence FindTapering(std::span<const ProfileEnds> horizontal,
                                      std::span<const ProfileEnds> vertical,
                                      const TaperingOptions& options) {
  sensor::TaperingEvidence tapering;
  tapering.monotone_horizontal =
      IsMonotone(horizontal, InMetres(options.horizontal_length, horizontal));
  tapering.monotone_vertical = IsMonotone(vertical, InMetres(options.vertical_length, vertical));
  const double horizontal_m = Asymmetry(horizontal, 0);
  const double vertical_m = Asymmetry(vertical, 1);
  tapering.asymmetric_ends = horizontal_m > InMetres(options.horizontal_step, horizontal) ||
                             vertical_m > InMetres(options.vertical_step, vertical);  // (5.8)
  tapering.asymmetry_m = std::max(horizontal_m, vertical_m);
  return tapering;
}

}  // namespace geon::recognition
