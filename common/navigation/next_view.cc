#include "navigation/next_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr int kBearings = 72;
constexpr double kStep_rad = 2.0 * kPi / kBearings;
constexpr double kRangeStep_m = ViewCoverage::kCell_m;
constexpr double kDeskDeep_m = 0.4;  // of a desk's top, that one look is for
constexpr double kBehind_m = 0.2;    // from an obstacle's front to where a target may stand
constexpr double kOver_1 = 0.3;      // what floor is worth that an obstacle may hide after all

double Elevation(double height_m, double range_m, const NextViewOptions& options) {
  return std::atan2(height_m + ViewCoverage::kMiddle_m - options.camera_height_m, range_m);
}

}  // namespace

std::optional<std::string> NextViewOptions::Validate() const {
  if (camera_height_m <= 0.0) return "camera_height_m must be positive";
  if (lowest_rad >= highest_rad) return "lowest_rad must be below highest_rad";
  if (farthest_m <= 0.0) return "farthest_m must be positive";
  if (floor_near_m < 0.0 || floor_far_m < floor_near_m) {
    return "floor_near_m must be at least 0 and at most floor_far_m";
  }
  if (speed_m_s <= 0.0 || turn_rate_rad_s <= 0.0) {
    return "speed_m_s and turn_rate_rad_s must be positive";
  }
  if (pause_s <= 0.0) return "pause_s must be positive";
  if (least_m2 <= 0.0) return "least_m2 must be positive, or the search never ends";
  if (most_m2 < least_m2) return "most_m2 must be at least least_m2";
  if (spacing_m <= 0.0) return "spacing_m must be positive";
  if (clearance_m < 0.0) return "clearance_m must not be negative";
  return std::nullopt;
}

std::vector<Unlooked> UnlookedFrom(const Eigen::Vector2d& place_W_m, const OccupancyGrid& map,
                                   const ViewCoverage& coverage, const NextViewOptions& options) {
  std::vector<Unlooked> unlooked;
  for (int k = 0; k < kBearings; ++k) {
    const double bearing_rad = WrapAngle(k * kStep_rad);
    const Eigen::Vector2d direction_W(std::cos(bearing_rad), std::sin(bearing_rad));
    const auto add = [&](size_t plane, double range_m, double deep_m, bool by_floor_camera) {
      const double elevation_rad = Elevation(coverage.planes()[plane].height_m, range_m, options);
      const Eigen::Vector2d p_W_m = place_W_m + range_m * direction_W;
      if (coverage.IsLooked(plane, p_W_m)) return;
      if (!by_floor_camera &&
          (elevation_rad < options.lowest_rad || elevation_rad > options.highest_rad)) {
        return;
      }
      unlooked.push_back({plane, p_W_m, bearing_rad, elevation_rad, range_m * kStep_rad * deep_m,
                          by_floor_camera});
    };
    const double sight_m = FreeSight(map, place_W_m, direction_W, options.farthest_m);
    for (double range_m = options.floor_near_m; range_m < sight_m; range_m += kRangeStep_m) {
      add(ViewCoverage::kFloor, range_m, kRangeStep_m, range_m <= options.floor_far_m);
    }
    if (sight_m >= options.farthest_m) continue;
    const double over_m = options.over_obstacles ? options.farthest_m : 0.0;
    for (double range_m = sight_m + kBehind_m; range_m < over_m; range_m += kRangeStep_m) {
      add(ViewCoverage::kFloorOverObstacles, range_m, kOver_1 * kRangeStep_m, false);
    }
    for (size_t desk = ViewCoverage::kFloorOverObstacles + 1; desk < coverage.planes().size();
         ++desk) {
      add(desk, sight_m + kBehind_m, kDeskDeep_m, false);
    }
  }
  return unlooked;
}

Arc ArcOf(std::span<const Unlooked> unlooked) {
  if (unlooked.empty()) return {};
  std::vector<double> bearings_rad;
  for (const Unlooked& each : unlooked) bearings_rad.push_back(each.bearing_W_rad);
  std::sort(bearings_rad.begin(), bearings_rad.end());
  // The arc begins after the widest gap.
  size_t first = 0;
  double widest_rad = bearings_rad.front() + 2.0 * kPi - bearings_rad.back();
  for (size_t i = 1; i < bearings_rad.size(); ++i) {
    const double gap_rad = bearings_rad[i] - bearings_rad[i - 1];
    if (gap_rad <= widest_rad) continue;
    widest_rad = gap_rad;
    first = i;
  }
  return {bearings_rad[first], 2.0 * kPi - widest_rad};
}

double AreaOf(std::span<const Unlooked> unlooked) {
  return std::accumulate(unlooked.begin(), unlooked.end(), 0.0,
                         [](double sum, const Unlooked& each) { return sum + each.area_m2; });
}

double Utility(std::span<const Unlooked> unlooked, double drive_m, const NextViewOptions& options) {
  const double area_m2 = AreaOf(unlooked);
  if (area_m2 < options.least_m2) return 0.0;
  return std::min(area_m2, options.most_m2) / (options.pause_s + drive_m / options.speed_m_s +
                                               ArcOf(unlooked).span_rad / options.turn_rate_rad_s);
}

std::optional<NextPlace> NextPlaceToLookFrom(
    const OccupancyGrid& map, const ViewCoverage& coverage, const ClearanceField& clearance,
    const CostToGo& drive, const std::function<bool(const Eigen::Vector2d&)>& is_given_up,
    const NextViewOptions& options) {
  const auto error = options.Validate();
  Require(!error, "NextViewOptions: " + error.value_or(""));
  const int stride = std::max(1, static_cast<int>(std::lround(options.spacing_m / map.cell_m())));
  std::optional<NextPlace> best;
  const auto weigh = [&](GridCell cell, const Eigen::Vector2d& place_W_m) {
    const double drive_m = drive.At(cell);
    if (!std::isfinite(drive_m) || clearance.At(cell) < options.clearance_m) return;
    if (is_given_up(place_W_m)) return;
    const auto unlooked = UnlookedFrom(place_W_m, map, coverage, options);
    const double utility_m2_s = Utility(unlooked, drive_m, options);
    if (utility_m2_s <= (best ? best->utility_m2_s : 0.0)) return;
    best = NextPlace{place_W_m, AreaOf(unlooked), utility_m2_s};
  };
  const GridWindow& window = drive.window();
  for (int y = window.first.y; y <= window.last.y; ++y) {
    for (int x = window.first.x; x <= window.last.x; ++x) {
      if (x % stride == 0 && y % stride == 0) weigh({x, y}, map.Middle({x, y}));
    }
  }
  return best;
}

}  // namespace geon::navigation
