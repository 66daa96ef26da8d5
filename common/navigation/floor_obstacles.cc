#include "navigation/floor_obstacles.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "navigation/floor_model.h"

namespace geon::navigation {

namespace {

// Where the ray through a pixel meets the floor, or nothing when it does not within the range.
std::optional<Eigen::Vector2d> OnFloor(double u_px, double v_px,
                                       const geometry::PinholeCamera& camera,
                                       const geometry::RigidTransform& X_RF, double max_range_m) {
  const Eigen::Vector3d ray_R = X_RF.linear() * camera.Ray(u_px, v_px);
  if (ray_R.z() >= 0.0) return std::nullopt;
  const Eigen::Vector3d p_R = X_RF.translation() - ray_R * (X_RF.translation().z() / ray_R.z());
  if (p_R.head<2>().norm() > max_range_m) return std::nullopt;
  return p_R.head<2>();
}

// A straight line of pixels, from the near end to the far one.
struct PixelLine {
  Eigen::Vector2d near_px, far_px;
};

// The part of a line that lies in the picture (Liang and Barsky 1984).
std::optional<PixelLine> Clipped(const PixelLine& line, const cv::Mat& picture) {
  const Eigen::Vector2d along_px = line.far_px - line.near_px;
  double from_1 = 0.0;
  double to_1 = 1.0;
  const auto clip = [&](double step_px, double room_px) {
    if (step_px == 0.0) return room_px >= 0.0;
    const double at_1 = room_px / step_px;
    (step_px < 0.0 ? from_1 : to_1) = step_px < 0.0 ? std::max(from_1, at_1) : std::min(to_1, at_1);
    return from_1 <= to_1;
  };
  const bool inside = clip(-along_px.x(), line.near_px.x()) &&
                      clip(along_px.x(), picture.cols - 1.0 - line.near_px.x()) &&
                      clip(-along_px.y(), line.near_px.y()) &&
                      clip(along_px.y(), picture.rows - 1.0 - line.near_px.y());
  if (!inside) return std::nullopt;
  return PixelLine{line.near_px + from_1 * along_px, line.near_px + to_1 * along_px};
}

// Where the ground straight away from below the camera is seen, as far as the range.
std::optional<PixelLine> GroundLine(double azimuth_rad, const geometry::PinholeCamera& camera,
                                    const geometry::RigidTransform& X_RF, double max_range_m) {
  constexpr double kInFront_m = 0.05;
  const Eigen::Vector2d outward(std::cos(azimuth_rad), std::sin(azimuth_rad));
  const Eigen::Vector2d foot_R_m = X_RF.translation().head<2>();
  const double along_m = foot_R_m.dot(outward);
  const double far_m =
      -along_m + std::sqrt(along_m * along_m + max_range_m * max_range_m - foot_R_m.squaredNorm());
  const Eigen::Vector3d outward_F =
      X_RF.linear().transpose() * Eigen::Vector3d(outward.x(), outward.y(), 0.0);
  const Eigen::Vector3d foot_F_m =
      X_RF.linear().transpose() * Eigen::Vector3d(0.0, 0.0, -X_RF.translation().z());
  const Eigen::Vector3d far_F_m = foot_F_m + far_m * outward_F;
  if (far_F_m.z() <= kInFront_m) return std::nullopt;
  const double near_m =
      foot_F_m.z() >= kInFront_m ? 0.0 : (kInFront_m - foot_F_m.z()) / outward_F.z();
  return PixelLine{camera.Project(foot_F_m + near_m * outward_F), camera.Project(far_F_m)};
}

std::optional<FloorColumn> FollowGround(const cv::Mat& not_floor, double azimuth_rad,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF,
                                        const FloorObstacleOptions& options) {
  const auto ground = GroundLine(azimuth_rad, camera, X_RF, options.max_range_m);
  const auto line = ground ? Clipped(*ground, not_floor) : std::nullopt;
  if (!line) return std::nullopt;
  const Eigen::Vector2d along_px = line->far_px - line->near_px;
  const int steps = static_cast<int>(std::ceil(along_px.cwiseAbs().maxCoeff()));
  const auto place = [&](double step) -> Eigen::Vector2d {
    return line->near_px + (steps == 0 ? 0.0 : std::clamp(step / steps, 0.0, 1.0)) * along_px;
  };
  bool obstacle = false;
  bool bright = false;
  int run_px = 0;
  int floor_steps = 0;
  for (int i = 0; i <= steps && !obstacle; ++i) {
    const Eigen::Vector2d p_px = place(i);
    const uint8_t pixel = not_floor.at<uint8_t>(static_cast<int>(std::lround(p_px.y())),
                                                static_cast<int>(std::lround(p_px.x())));
    if (pixel == 0) {
      run_px = 0;
      floor_steps = i + 1;
    } else {
      bright = pixel == kBrightMask && (bright || run_px == 0);
      obstacle = ++run_px >= options.min_run_px;
    }
  }
  // The near edge of the first pixel that is no floor: where the obstacle can begin at the nearest.
  auto column = FloorBetween(place(0.0), place(std::max(0.0, floor_steps - 0.5)), obstacle, camera,
                             X_RF, options.max_range_m);
  if (column) column->bright = obstacle && bright;
  return column;
}

}  // namespace

bool FloorObstacleOptions::IsValid(std::string* error) const {
  const bool valid = max_range_m > 0.0 && min_run_px >= 1 && column_step_px >= 1;
  if (!valid && error != nullptr) *error = "ranges, runs and steps must be positive";
  return valid;
}

std::vector<FloorColumn> FloorObstacles(const cv::Mat& not_floor,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF,
                                        const FloorObstacleOptions& options) {
  Require(not_floor.type() == CV_8UC1, "FloorObstacles: the mask must be 8-bit");
  Require(not_floor.cols == camera.width_px && not_floor.rows == camera.height_px,
          "FloorObstacles: the mask has not the camera's size");
  std::string error;
  Require(options.IsValid(&error), error);
  // From the lower left corner to the lower right one.
  const auto azimuth = [&](double u_px) {
    const Eigen::Vector3d ray_R = X_RF.linear() * camera.Ray(u_px, camera.height_px - 1.0);
    return std::atan2(ray_R.y(), ray_R.x());
  };
  const double left_rad = azimuth(0.0);
  const double right_rad = azimuth(camera.width_px - 1.0);
  const int directions = std::max(2, camera.width_px / options.column_step_px);
  std::vector<FloorColumn> columns;
  for (int k = 0; k < directions; ++k) {
    const double share_1 = (k + 0.5) / directions;
    const auto column =
        FollowGround(not_floor, left_rad + share_1 * (right_rad - left_rad), camera, X_RF, options);
    if (column) columns.push_back(*column);
  }
  return columns;
}

std::optional<FloorColumn> FloorBetween(const Eigen::Vector2d& begin_px,
                                        const Eigen::Vector2d& end_px, bool obstacle,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF, double max_range_m) {
  constexpr double kRounding_1 = 1.01;
  const auto begin_R_m =
      OnFloor(begin_px.x(), begin_px.y(), camera, X_RF, kRounding_1 * max_range_m);
  const auto end_R_m = OnFloor(end_px.x(), end_px.y(), camera, X_RF, kRounding_1 * max_range_m);
  if (!begin_R_m || !end_R_m) return std::nullopt;
  return FloorColumn{*begin_R_m, *end_R_m, obstacle};
}

}  // namespace geon::navigation
