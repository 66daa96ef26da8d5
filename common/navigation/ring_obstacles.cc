#include "navigation/ring_obstacles.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {

namespace {

constexpr int kFullInfraredLevel = 15;

Eigen::Vector2d OnAxis(int sensor, int count, double distance_m) {
  const double bearing_rad = 2.0 * kPi * sensor / count;
  return {distance_m * std::cos(bearing_rad), distance_m * std::sin(bearing_rad)};
}

}  // namespace

bool RingOptions::IsValid(std::string* error) const {
  const bool valid = sonar_radius_m >= 0.0 && infrared_radius_m >= 0.0 && sonar_min_m > 0.0 &&
                     sonar_max_m > sonar_min_m && infrared_reach_m > 0.0 &&
                     infrared_min_level >= 1 && infrared_min_level <= kFullInfraredLevel;
  if (!valid && error != nullptr) {
    *error = "radii must not be negative, 0 < sonar_min_m < sonar_max_m, level 1..15";
  }
  return valid;
}

std::vector<Eigen::Vector2d> SonarObstacles(const sensor::SonarScan& scan,
                                            const RingOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);
  std::vector<Eigen::Vector2d> points_R_m;
  for (int i = 0; i < sensor::kSonarCount; ++i) {
    const double range_m = scan.range_m[static_cast<size_t>(i)];
    if (!std::isfinite(range_m) || range_m > options.sonar_max_m) continue;
    const double seen_m = std::max(range_m, options.sonar_min_m);
    points_R_m.push_back(OnAxis(i, sensor::kSonarCount, options.sonar_radius_m + seen_m));
  }
  return points_R_m;
}

std::vector<Eigen::Vector2d> InfraredObstacles(const sensor::InfraredScan& scan,
                                               const RingOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);
  std::vector<Eigen::Vector2d> points_R_m;
  for (int i = 0; i < sensor::kInfraredCount; ++i) {
    const int level = std::min(scan.level[static_cast<size_t>(i)], kFullInfraredLevel);
    if (level < options.infrared_min_level) continue;
    const double far_1 = 1.0 - static_cast<double>(level) / kFullInfraredLevel;
    points_R_m.push_back(
        OnAxis(i, sensor::kInfraredCount,
               options.infrared_radius_m + options.infrared_reach_m * far_1 * far_1));
  }
  return points_R_m;
}

}  // namespace geon::navigation
