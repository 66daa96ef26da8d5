#include "recognition/find_tapering.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// (5.4-5.7): strictly rising or strictly falling, every step above the tolerance.
bool IsMonotone(std::span<const ProfileEnds> ends, const TaperingOptions& options) {
  if (ends.size() < 3) return false;
  int rising = 0;
  int falling = 0;
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    const double longer_m = std::max(ends[i].length_m, ends[i + 1].length_m);
    const double tolerance_m = options.length_tolerance_m + options.length_tolerance_1 * longer_m;
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
      const Eigen::Vector2d& a = first ? ends[j].first_m : ends[j].last_m;
      const Eigen::Vector2d& b = first ? ends[j + 1].first_m : ends[j + 1].last_m;
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
  Require(length_tolerance_m >= 0.0,
          "length_tolerance_m is " + std::to_string(length_tolerance_m) + ", must not be negative");
  Require(length_tolerance_1 >= 0.0,
          "length_tolerance_1 is " + std::to_string(length_tolerance_1) + ", must not be negative");
  Require(asymmetry_m > 0.0,
          "asymmetry_m is " + std::to_string(asymmetry_m) + ", must be positive");
}

sensor::TaperingEvidence FindTapering(std::span<const ProfileEnds> horizontal,
                                      std::span<const ProfileEnds> vertical,
                                      const TaperingOptions& options) {
  sensor::TaperingEvidence tapering;
  tapering.monotone_horizontal = IsMonotone(horizontal, options);
  tapering.monotone_vertical = IsMonotone(vertical, options);
  tapering.asymmetry_m = std::max(Asymmetry(horizontal, 0), Asymmetry(vertical, 1));
  tapering.asymmetric_ends = tapering.asymmetry_m > options.asymmetry_m;  // (5.8)
  return tapering;
}

}  // namespace geon::recognition
