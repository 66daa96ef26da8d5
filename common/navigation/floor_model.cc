#include "navigation/floor_model.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/contracts.h"
#include "base/median.h"

namespace geon::navigation {

namespace {

constexpr size_t kFewestPixels = 200;  // of a patch, to learn from
constexpr double kMostMoved_m = 0.25;  // else echoes say too little of where things are now

// Larger ones first, then what is left of them beside or before a wall.
constexpr FloorPatch kPatches[] = {{0.45, 0.85, -0.20, 0.20},
                                   {0.45, 0.75, 0.00, 0.30},
                                   {0.45, 0.75, -0.30, 0.00},
                                   {0.42, 0.62, -0.15, 0.15}};

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

bool IsFloor(const Colour& colour, const FloorModel& model) {
  return OffColour(colour, model) <= model.share_tolerance_1 &&
         colour.level >= model.darkest_1 * model.level &&
         colour.level <= model.brightest_1 * model.level;
}

// Of what is no floor: a mirrored lamp adds its own colour to that of the floor it lights.
bool IsBright(const Colour& colour, const FloorModel& model) {
  return colour.level > model.brightest_1 * model.level &&
         OffColour(colour, model) <= kLampTolerance_1;
}

// Standard deviation about a median, from the median of distances, which seams and specks do not
// move.
double Spread(std::vector<double> values, double median) {
  for (double& value : values) value = std::abs(value - median);
  return 1.4826 * Median(std::move(values));
}

// Whether the ray through a pixel meets the ground in a patch.
bool IsIn(const FloorPatch& patch, double u_px, double v_px, const geometry::PinholeCamera& camera,
          const geometry::RigidTransform& X_RF) {
  const Eigen::Vector3d ray_R = X_RF.linear() * camera.Ray(u_px, v_px);
  if (ray_R.z() >= 0.0) return false;
  const Eigen::Vector3d p_R = X_RF.translation() - ray_R * (X_RF.translation().z() / ray_R.z());
  return p_R.x() >= patch.near_m && p_R.x() <= patch.far_m && p_R.y() >= patch.right_m &&
         p_R.y() <= patch.left_m;
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

cv::Mat NotFloorMask(const cv::Mat& image_bgr, const FloorModel& model) {
  Require(image_bgr.type() == CV_8UC3, "NotFloorMask: the image must be 8-bit BGR");
  cv::Mat mask(image_bgr.size(), CV_8UC1);
  for (int v_px = 0; v_px < image_bgr.rows; ++v_px) {
    for (int u_px = 0; u_px < image_bgr.cols; ++u_px) {
      const Colour colour = ColourOf(image_bgr.at<cv::Vec3b>(v_px, u_px));
      uint8_t* pixel = &mask.at<uint8_t>(v_px, u_px);
      if (IsFloor(colour, model)) {
        *pixel = 0;
      } else {
        *pixel = IsBright(colour, model) ? kBrightMask : 255;
      }
    }
  }
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  return mask;
}

bool PatchIsFree(const RingEchoes& echoes, const FloorPatch& patch) {
  if (echoes.moved_m > kMostMoved_m) return false;
  return std::all_of(
      echoes.points_R_m.begin(), echoes.points_R_m.end(), [&](const Eigen::Vector2d& echo_m) {
        const Eigen::Vector2d normal = echo_m.normalized();
        const double reach_m = std::max(patch.near_m * normal.x(), patch.far_m * normal.x()) +
                               std::max(patch.right_m * normal.y(), patch.left_m * normal.y());
        return reach_m + echoes.moved_m < echo_m.norm();
      });
}

std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const FloorPatch& patch) {
  Require(image_bgr.type() == CV_8UC3, "LearnFloor: the image must be 8-bit BGR");
  std::vector<double> red_1;
  std::vector<double> green_1;
  std::vector<double> level;
  std::vector<cv::Vec3b> pixels;
  for (int v_px = 0; v_px < image_bgr.rows; ++v_px) {
    for (int u_px = 0; u_px < image_bgr.cols; ++u_px) {
      if (!IsIn(patch, u_px, v_px, camera, X_RF)) continue;
      pixels.push_back(image_bgr.at<cv::Vec3b>(v_px, u_px));
      const Colour colour = ColourOf(pixels.back());
      red_1.push_back(colour.red_share_1);
      green_1.push_back(colour.green_share_1);
      level.push_back(colour.level);
    }
  }
  if (pixels.size() < kFewestPixels) return std::nullopt;

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
  if (!IsFloor(ColourOf(median_bgr), wide)) return std::nullopt;
  const auto alike = std::count_if(pixels.begin(), pixels.end(),
                                   [&](const auto& bgr) { return IsFloor(ColourOf(bgr), model); });
  if (static_cast<double>(alike) < 0.9 * static_cast<double>(pixels.size())) return std::nullopt;
  return model;
}

std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const RingEchoes& echoes) {
  for (const FloorPatch& patch : kPatches) {
    if (!PatchIsFree(echoes, patch)) continue;
    if (auto model = LearnFloor(image_bgr, camera, X_RF, prior, patch)) return model;
  }
  return std::nullopt;
}

}  // namespace geon::navigation
