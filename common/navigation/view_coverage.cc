#include "navigation/view_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr double kSightStep_m = 0.05;
constexpr double kMargin_px = 4.0;  // nearer to the picture's edge nothing counts as looked at

bool Blocks(const OccupancyGrid& map, GridCell cell) {
  return map.ObstacleIn(cell) || map.ObstacleIn({cell.x + 1, cell.y}) ||
         map.ObstacleIn({cell.x - 1, cell.y}) || map.ObstacleIn({cell.x, cell.y + 1}) ||
         map.ObstacleIn({cell.x, cell.y - 1});
}

bool IsInPicture(const geometry::PinholeCamera& camera, const geometry::RigidTransform& X_CW,
                 const Eigen::Vector3d& p_W_m) {
  const Eigen::Vector3d p_C_m = X_CW * p_W_m;
  if (p_C_m.z() <= 0.05) return false;
  const Eigen::Vector2d pixel_px = camera.Project(p_C_m);
  return pixel_px.x() > kMargin_px && pixel_px.x() < camera.width_px - 1 - kMargin_px &&
         pixel_px.y() > kMargin_px && pixel_px.y() < camera.height_px - 1 - kMargin_px;
}

// The bearings (W) that a picture covers: from the first, over so many radians.
struct Bearings {
  double first_rad = 0.0;
  double span_rad = 0.0;
};
Bearings BearingsOf(const geometry::PinholeCamera& camera, const geometry::RigidTransform& X_WC) {
  const Eigen::Vector3d axis_W = X_WC.linear().col(2);
  const double middle_rad = std::atan2(axis_W.y(), axis_W.x());
  double right_rad = 0.0, left_rad = 0.0;
  for (const double u_px : {0.0, camera.width_px - 1.0}) {
    for (const double v_px : {0.0, camera.height_px - 1.0}) {
      const Eigen::Vector3d ray_W = X_WC.linear() * camera.Ray(u_px, v_px);
      const double bearing_rad = WrapAngle(std::atan2(ray_W.y(), ray_W.x()) - middle_rad);
      right_rad = std::min(right_rad, bearing_rad);
      left_rad = std::max(left_rad, bearing_rad);
    }
  }
  return {middle_rad + right_rad, left_rad - right_rad};
}

}  // namespace

double FreeSight(const OccupancyGrid& map, const Eigen::Vector2d& from_W_m,
                 const Eigen::Vector2d& direction_W, double farthest_m) {
  // The robot itself stands where it looks from.
  constexpr double kOwn_m = 0.2;
  for (double r_m = kOwn_m; r_m < farthest_m; r_m += kSightStep_m) {
    if (Blocks(map, map.CellAt(from_W_m + r_m * direction_W))) return r_m;
  }
  return farthest_m;
}

ViewCoverage::ViewCoverage(const std::vector<double>& support_heights_m, double reach_m)
    : planes_{{0.0, false}, {0.0, true}}, half_(static_cast<int>(reach_m / kCell_m)) {
  for (const double height_m : support_heights_m) {
    if (height_m > 0.0) planes_.push_back({height_m, true});
  }
  Require(planes_.size() <= 8, "ViewCoverage: at most six heights of supports above the floor");
  Require(half_ > 0, "ViewCoverage: reach_m must be larger than a cell");
  Clear();
}

void ViewCoverage::Clear() { looked_.assign(static_cast<size_t>(4 * half_ * half_), 0); }

int ViewCoverage::Index(const Eigen::Vector2d& p_W_m) const {
  const int x = static_cast<int>(std::floor(p_W_m.x() / kCell_m)) + half_;
  const int y = static_cast<int>(std::floor(p_W_m.y() / kCell_m)) + half_;
  return x < 0 || y < 0 || x >= 2 * half_ || y >= 2 * half_ ? -1 : y * 2 * half_ + x;
}

void ViewCoverage::Mark(size_t plane, const Eigen::Vector2d& p_W_m) {
  const int index = Index(p_W_m);
  if (index >= 0) looked_[static_cast<size_t>(index)] |= static_cast<uint8_t>(1U << plane);
}

bool ViewCoverage::IsLooked(size_t plane, const Eigen::Vector2d& p_W_m) const {
  const int index = Index(p_W_m);
  return index < 0 || (looked_[static_cast<size_t>(index)] >> plane & 1U) != 0;
}

void ViewCoverage::Look(const geometry::PinholeCamera& camera, const geometry::RigidTransform& X_WC,
                        double farthest_m, const OccupancyGrid& map) {
  const geometry::RigidTransform X_CW = X_WC.inverse();
  const Eigen::Vector2d from_W_m = X_WC.translation().head<2>();
  const Bearings bearings = BearingsOf(camera, X_WC);
  const int rays = 1 + static_cast<int>(bearings.span_rad * farthest_m / (0.8 * kCell_m));
  for (int k = 0; k <= rays; ++k) {
    const double bearing_rad = bearings.first_rad + bearings.span_rad * k / rays;
    const Eigen::Vector2d direction_W(std::cos(bearing_rad), std::sin(bearing_rad));
    const double sight_m = FreeSight(map, from_W_m, direction_W, farthest_m);
    for (size_t plane = 0; plane < planes_.size(); ++plane) {
      const double reach_m = planes_[plane].over_obstacles ? farthest_m : sight_m;
      for (double r_m = 0.0; r_m < reach_m; r_m += 0.5 * kCell_m) {
        const Eigen::Vector2d p_W_m = from_W_m + r_m * direction_W;
        const Eigen::Vector3d middle_W_m(p_W_m.x(), p_W_m.y(), planes_[plane].height_m + kMiddle_m);
        if (IsInPicture(camera, X_CW, middle_W_m)) Mark(plane, p_W_m);
      }
    }
  }
}

}  // namespace geon::navigation
