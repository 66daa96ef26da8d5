#include "navigation/floor_obstacles.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/contracts.h"
#include "base/median.h"

namespace geon::navigation {

namespace {

struct Colour {
  double red_share_1;
  double green_share_1;
  double level;
};

Colour ColourOf(const cv::Vec3b& bgr) {
  const double sum = bgr[0] + bgr[1] + bgr[2];
  if (sum <= 0.0) return {1.0 / 3.0, 1.0 / 3.0, 0.0};
  return {bgr[2] / sum, bgr[1] / sum, sum / 3.0};
}

constexpr double kNoiseMargin_1 = 4.5;     // standard deviations of floor that are still floor
constexpr double kLampTolerance_1 = 0.07;  // in each share, between lamps of 3000 and 6500 kelvin

// The largest difference in a share.
double OffColour(const Colour& colour, const FloorModel& model) {
  const double red_1 = colour.red_share_1 - model.red_share_1;
  const double green_1 = colour.green_share_1 - model.green_share_1;
  const double blue_1 = -red_1 - green_1;
  return std::max({std::abs(red_1), std::abs(green_1), std::abs(blue_1)});
}

bool IsFloor(const cv::Vec3b& bgr, const FloorModel& model) {
  const Colour colour = ColourOf(bgr);
  return OffColour(colour, model) <= model.share_tolerance_1 &&
         colour.level >= model.darkest_1 * model.level &&
         colour.level <= model.brightest_1 * model.level;
}

// Of what is no floor: a mirrored lamp adds its own colour to that of the floor it lights.
bool IsBright(const cv::Vec3b& bgr, const FloorModel& model) {
  const Colour colour = ColourOf(bgr);
  return colour.level > model.brightest_1 * model.level &&
         OffColour(colour, model) <= kLampTolerance_1;
}

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

// Standard deviation about a median, from the median of distances, which seams and specks do not
// move.
double Spread(std::vector<double> values, double median) {
  for (double& value : values) value = std::abs(value - median);
  return 1.4826 * Median(std::move(values));
}

}  // namespace

FloorModel FloorModel::OfColor(const std::array<double, 3>& color_rgb) {
  const double sum = color_rgb[0] + color_rgb[1] + color_rgb[2];
  Require(sum > 0.0, "FloorModel::OfColor: black has no colour");
  FloorModel model;
  model.red_share_1 = color_rgb[0] / sum;
  model.green_share_1 = color_rgb[1] / sum;
  model.level = sum / 3.0;
  return model;
}

bool FloorModel::IsValid(std::string* error) const {
  const bool valid = red_share_1 >= 0.0 && green_share_1 >= 0.0 &&
                     red_share_1 + green_share_1 <= 1.0 && level > 0.0 && share_tolerance_1 > 0.0 &&
                     darkest_1 >= 0.0 && darkest_1 < 1.0 && brightest_1 > 1.0;
  if (!valid && error != nullptr) {
    *error = "shares within 0..1, level and tolerance positive, darkest_1 < 1 < brightest_1";
  }
  return valid;
}

bool FloorObstacleOptions::IsValid(std::string* error) const {
  const bool valid = max_range_m > 0.0 && min_run_px >= 1 && column_step_px >= 1 &&
                     patch_near_m > 0.0 && patch_far_m > patch_near_m && patch_half_width_m > 0.0;
  if (!valid && error != nullptr)
    *error = "ranges, runs and steps positive, patch_near < patch_far";
  return valid;
}

cv::Mat NotFloorMask(const cv::Mat& image_bgr, const FloorModel& model) {
  Require(image_bgr.type() == CV_8UC3, "NotFloorMask: the image must be 8-bit BGR");
  cv::Mat mask(image_bgr.size(), CV_8UC1);
  for (int v_px = 0; v_px < image_bgr.rows; ++v_px) {
    for (int u_px = 0; u_px < image_bgr.cols; ++u_px) {
      const cv::Vec3b& pixel = image_bgr.at<cv::Vec3b>(v_px, u_px);
      const uint8_t other = IsBright(pixel, model) ? kBrightMask : 255;
      mask.at<uint8_t>(v_px, u_px) = IsFloor(pixel, model) ? 0 : other;
    }
  }
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  return mask;
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

bool PatchIsFree(std::span<const Eigen::Vector2d> echoes_R_m, const FloorObstacleOptions& options) {
  return std::all_of(echoes_R_m.begin(), echoes_R_m.end(), [&](const Eigen::Vector2d& echo_m) {
    const Eigen::Vector2d normal = echo_m.normalized();
    const double reach_m =
        std::max(options.patch_near_m * normal.x(), options.patch_far_m * normal.x()) +
        options.patch_half_width_m * std::abs(normal.y());
    return reach_m < echo_m.norm();
  });
}

std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const FloorObstacleOptions& options) {
  Require(image_bgr.type() == CV_8UC3, "LearnFloor: the image must be 8-bit BGR");
  std::vector<double> red_1;
  std::vector<double> green_1;
  std::vector<double> level;
  std::vector<cv::Vec3b> patch;
  for (int v_px = 0; v_px < image_bgr.rows; ++v_px) {
    for (int u_px = 0; u_px < image_bgr.cols; ++u_px) {
      const auto p_R_m = OnFloor(u_px, v_px, camera, X_RF, options.max_range_m);
      if (!p_R_m || p_R_m->x() < options.patch_near_m || p_R_m->x() > options.patch_far_m ||
          std::abs(p_R_m->y()) > options.patch_half_width_m) {
        continue;
      }
      patch.push_back(image_bgr.at<cv::Vec3b>(v_px, u_px));
      const Colour colour = ColourOf(patch.back());
      red_1.push_back(colour.red_share_1);
      green_1.push_back(colour.green_share_1);
      level.push_back(colour.level);
    }
  }
  if (patch.empty()) return std::nullopt;

  FloorModel model = prior;
  model.red_share_1 = Median(red_1);
  model.green_share_1 = Median(green_1);
  model.level = Median(std::move(level));
  const double noise_1 =
      std::max(Spread(red_1, model.red_share_1), Spread(green_1, model.green_share_1));
  model.share_tolerance_1 =
      std::clamp(kNoiseMargin_1 * noise_1, prior.share_tolerance_1, 2.0 * prior.share_tolerance_1);
  const auto median_bgr =
      cv::Vec3b(cv::saturate_cast<uint8_t>(3.0 * model.level *
                                           (1.0 - model.red_share_1 - model.green_share_1)),
                cv::saturate_cast<uint8_t>(3.0 * model.level * model.green_share_1),
                cv::saturate_cast<uint8_t>(3.0 * model.level * model.red_share_1));
  // Lamps differ from room to room.
  FloorModel wide = prior;
  wide.share_tolerance_1 = kLampTolerance_1;
  wide.darkest_1 = 0.5;
  wide.brightest_1 = 2.0;
  if (!IsFloor(median_bgr, wide)) return std::nullopt;
  const auto alike = std::count_if(patch.begin(), patch.end(),
                                   [&](const auto& bgr) { return IsFloor(bgr, model); });
  if (static_cast<double>(alike) < 0.9 * static_cast<double>(patch.size())) return std::nullopt;
  return model;
}

}  // namespace geon::navigation
