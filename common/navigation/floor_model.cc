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

// Whether the ray through a pixel meets the ground in a patch.
bool IsIn(const FloorPatch& patch, double u_px, double v_px, const geometry::PinholeCamera& camera,
          const geometry::RigidTransform& X_RF) {
  const Eigen::Vector3d ray_R = X_RF.linear() * camera.Ray(u_px, v_px);
  if (ray_R.z() >= 0.0) return false;
  const Eigen::Vector3d p_R = X_RF.translation() - ray_R * (X_RF.translation().z() / ray_R.z());
  return p_R.x() >= patch.near_m && p_R.x() <= patch.far_m && p_R.y() >= patch.right_m &&
         p_R.y() <= patch.left_m;
}

// The noise of a colour channel, as a standard deviation, from the median of differences: seams and
// edges do not move it, nor do two colours side by side.
double Noise(std::vector<double> differences) {
  for (double& difference : differences) difference = std::abs(difference);
  return 1.4826 / std::sqrt(2.0) * Median(std::move(differences));
}

// The part of the picture that the patch lies in, nearly: a lens bends its sides a little.
cv::Rect BoundsOf(const FloorPatch& patch, const cv::Size& size_px,
                  const geometry::PinholeCamera& camera, const geometry::RigidTransform& X_RF) {
  const cv::Rect picture_px(cv::Point(), size_px);
  std::vector<cv::Point2f> corners_px;
  for (const double x_m : {patch.near_m, patch.far_m}) {
    for (const double y_m : {patch.right_m, patch.left_m}) {
      const Eigen::Vector3d p_F = X_RF.inverse() * Eigen::Vector3d(x_m, y_m, 0.0);
      if (p_F.z() <= 0.0) return picture_px;
      const Eigen::Vector2d p_px = camera.Project(p_F);
      corners_px.emplace_back(static_cast<float>(p_px.x()), static_cast<float>(p_px.y()));
    }
  }
  return cv::boundingRect(corners_px) & picture_px;
}

// The pixels that show the patch.
std::vector<cv::Point> PixelsOf(const FloorPatch& patch, const cv::Mat& image_bgr,
                                const geometry::PinholeCamera& camera,
                                const geometry::RigidTransform& X_RF) {
  Require(image_bgr.type() == CV_8UC3, "LearnFloor: the image must be 8-bit BGR");
  std::vector<cv::Point> pixels;
  const cv::Rect bounds_px = BoundsOf(patch, image_bgr.size(), camera, X_RF);
  for (int v_px = bounds_px.y; v_px < bounds_px.br().y; ++v_px) {
    for (int u_px = bounds_px.x; u_px < bounds_px.br().x; ++u_px) {
      if (IsIn(patch, u_px, v_px, camera, X_RF)) pixels.emplace_back(u_px, v_px);
    }
  }
  return pixels;
}

// The colour of these pixels with the tolerances of `prior`, wider where the picture is noisy, when
// nine tenths of them have that colour.
std::optional<FloorModel> LearnOneColour(const cv::Mat& image_bgr,
                                         const std::vector<cv::Point>& pixels,
                                         const FloorModel& prior) {
  if (pixels.size() < kFewestPixels) return std::nullopt;
  constexpr int kApart_px = 4;  // no neighbours: a camera with a colour filter mixes these
  std::vector<double> red_1, green_1, level, red_steps_1, green_steps_1;
  for (const cv::Point& p_px : pixels) {
    const Colour colour = ColourOf(image_bgr.at<cv::Vec3b>(p_px));
    red_1.push_back(colour.red_share_1);
    green_1.push_back(colour.green_share_1);
    level.push_back(colour.level);
    const cv::Point beside_px(p_px.x + (p_px.x < kApart_px ? kApart_px : -kApart_px), p_px.y);
    const Colour beside = ColourOf(image_bgr.at<cv::Vec3b>(beside_px));
    red_steps_1.push_back(colour.red_share_1 - beside.red_share_1);
    green_steps_1.push_back(colour.green_share_1 - beside.green_share_1);
  }
  FloorModel model = prior;
  model.red_share_1 = Median(red_1);
  model.green_share_1 = Median(green_1);
  model.level = Median(level);
  const double noise_1 = std::max(Noise(std::move(red_steps_1)), Noise(std::move(green_steps_1)));
  model.share_tolerance_1 =
      std::clamp(kNoiseMargin_1 * noise_1, prior.share_tolerance_1, 2.0 * prior.share_tolerance_1);
  size_t alike = 0;
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (IsFloor({red_1[i], green_1[i], level[i]}, model)) ++alike;
  }
  constexpr double kAlike_1 = 0.9;
  if (static_cast<double>(alike) < kAlike_1 * static_cast<double>(pixels.size())) {
    return std::nullopt;
  }
  return model;
}

// Whether floor that is brighter in the sun may look so in the shade. There a lamp lights it, whose
// light is warmer than the sun's or a little colder; along the colours of black bodies green falls
// by about a fifth of what red falls.
bool AreSunAndShade(const FloorModel& sun, const FloorModel& shade) {
  constexpr double kWeakest_1 = 1.35, kStrongest_1 = 5.0;  // sun, times brighter than the shade
  constexpr double kWarmer_1 = 0.06, kCooler_1 = 0.010, kGreenPerRed_1 = 0.22, kOff_1 = 0.005;
  const double ratio_1 = sun.level / shade.level;
  const double warmer_1 = shade.red_share_1 - sun.red_share_1;
  const double greener_1 = shade.green_share_1 - sun.green_share_1;
  return ratio_1 >= kWeakest_1 && ratio_1 <= kStrongest_1 && warmer_1 >= -kCooler_1 &&
         warmer_1 <= kWarmer_1 && std::abs(greener_1 - kGreenPerRed_1 * warmer_1) <= kOff_1;
}

// Whether the light that makes the difference between floor in the sun and in the shade may be the
// sun's: daylight is at the cool end of the lamps that a room may have.
bool DifferBySunlight(const FloorModel& sun, const FloorModel& shade, const FloorModel& prior) {
  constexpr double kCoolest_1 = 0.06, kWarmest_1 = 0.02, kGreen_1 = 0.02;  // off the prior's shares
  constexpr double kGamma_1 = 2.2;                                         // of a camera's picture
  const auto added = [](double sun_level, double shade_level) {
    const double light = std::pow(sun_level, kGamma_1) - std::pow(shade_level, kGamma_1);
    return std::pow(std::max(0.0, light), 1.0 / kGamma_1);
  };
  const auto blue_share_1 = [](const FloorModel& m) {
    return 1.0 - m.red_share_1 - m.green_share_1;
  };
  const double red = added(sun.level * sun.red_share_1, shade.level * shade.red_share_1);
  const double green = added(sun.level * sun.green_share_1, shade.level * shade.green_share_1);
  const double blue = added(sun.level * blue_share_1(sun), shade.level * blue_share_1(shade));
  const double sum = red + green + blue;
  if (sum <= 0.0) return false;
  const double cooler_1 = prior.red_share_1 - red / sum;
  return cooler_1 >= kWarmest_1 && cooler_1 <= kCoolest_1 &&
         std::abs(green / sum - prior.green_share_1) <= kGreen_1;
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

cv::Mat NotFloorMask(const cv::Mat& image_bgr, std::span<const FloorModel> models) {
  Require(image_bgr.type() == CV_8UC3, "NotFloorMask: the image must be 8-bit BGR");
  Require(!models.empty(), "NotFloorMask: a model of the floor is needed");
  cv::Mat mask(image_bgr.size(), CV_8UC1);
  for (int v_px = 0; v_px < image_bgr.rows; ++v_px) {
    for (int u_px = 0; u_px < image_bgr.cols; ++u_px) {
      const Colour colour = ColourOf(image_bgr.at<cv::Vec3b>(v_px, u_px));
      uint8_t* pixel = &mask.at<uint8_t>(v_px, u_px);
      const auto is_floor = [&](const FloorModel& model) { return IsFloor(colour, model); };
      const auto is_bright = [&](const FloorModel& model) { return IsBright(colour, model); };
      if (std::any_of(models.begin(), models.end(), is_floor)) {
        *pixel = 0;
      } else {
        *pixel = std::any_of(models.begin(), models.end(), is_bright) ? kBrightMask : 255;
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
  auto model = LearnOneColour(image_bgr, PixelsOf(patch, image_bgr, camera, X_RF), prior);
  // Lamps differ from room to room.
  FloorModel wide = prior;
  wide.share_tolerance_1 = kLampTolerance_1;
  wide.darkest_1 = 0.5;
  wide.brightest_1 = 2.0;
  if (model && !IsFloor({model->red_share_1, model->green_share_1, model->level}, wide)) {
    return std::nullopt;
  }
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

std::optional<std::array<FloorModel, 2>> LearnOtherLight(const cv::Mat& image_bgr,
                                                         const geometry::PinholeCamera& camera,
                                                         const geometry::RigidTransform& X_RF,
                                                         const FloorModel& known,
                                                         const FloorModel& prior,
                                                         const RingEchoes& echoes) {
  constexpr double kMost_1 = 0.7;  // of the patch may be as known, the other light beside it
  constexpr double kDarkestSun_1 = 0.85;
  for (const FloorPatch& patch : kPatches) {
    if (!PatchIsFree(echoes, patch)) continue;
    auto pixels = PixelsOf(patch, image_bgr, camera, X_RF);
    const auto all = static_cast<double>(pixels.size());
    std::erase_if(pixels, [&](const cv::Point& p_px) {
      return IsFloor(ColourOf(image_bgr.at<cv::Vec3b>(p_px)), known);
    });
    if (static_cast<double>(pixels.size()) < (1.0 - kMost_1) * all) continue;
    auto other = LearnOneColour(image_bgr, pixels, known);
    if (!other) continue;
    std::array<FloorModel, 2> lights = {known, *other};
    const bool darker = other->level < known.level;
    if (darker) std::swap(lights[0], lights[1]);
    auto& [shade, sun] = lights;
    if (!AreSunAndShade(sun, shade)) continue;
    // Else the side of a box, away from the lamp, is floor in the shade.
    if (darker && !DifferBySunlight(sun, shade, prior)) continue;
    sun.darkest_1 = kDarkestSun_1;
    return lights;
  }
  return std::nullopt;
}

}  // namespace geon::navigation
