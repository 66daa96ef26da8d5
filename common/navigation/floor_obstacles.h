#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"

namespace geon::navigation {

// What colour the floor has, as the floor camera sees it: the channels' shares in their sum (which
// shadows hardly change), and a window of brightness (which separates grey from black and glare).
struct FloorModel {
  double red_share_1 = 1.0 / 3.0;
  double green_share_1 = 1.0 / 3.0;
  double level = 150.0;              // mean of the three channels, 0..255
  double share_tolerance_1 = 0.012;  // half-width of the window in each of the three shares
  double darkest_1 = 0.6;     // window of brightness, as a part of `level`: seams and shadows
  double brightest_1 = 1.35;  // stay inside

  // A model of a floor of this colour (0..255), tolerances as above.
  static FloorModel OfColor(const std::array<double, 3>& color_rgb);
  bool IsValid(std::string* error) const;
};

struct FloorObstacleOptions {
  double max_range_m = 3.0;  // farther ones are not asked for
  int min_run_px = 3;        // an obstacle fills at least so many pixels in its direction
  int column_step_px = 4;    // one direction for this many of the picture's columns
  // The patch that LearnFloor trusts to be floor: in front of the robot, clear of it.
  double patch_near_m = 0.45;
  double patch_far_m = 0.85;
  double patch_half_width_m = 0.20;

  bool IsValid(std::string* error) const;
};

// What the floor camera saw of the ground in one direction, straight away from below the camera:
// floor from `begin` (the picture's edge) to `end`, and whether something else begins there (or
// only the range or the picture ends).
struct FloorColumn {
  Eigen::Vector2d begin_R_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d end_R_m = Eigen::Vector2d::Zero();
  bool obstacle = false;
  // That is brighter than the floor and has no other colour: maybe a lamp's image in the floor.
  bool bright = false;
};

// In the mask: what is brighter than the floor, and no more coloured than a lamp.
inline constexpr uint8_t kBrightMask = 128;

// 255 or kBrightMask where a pixel has not the floor's colour; specks and lines under 3 pixels are
// gone. `image_bgr` CV_8UC3.
cv::Mat NotFloorMask(const cv::Mat& image_bgr, const FloorModel& model);

// Nearest points that are not floor, by direction, from left to right.
//
// Source: thesis section 4.3, assumptions (i) and (iii): the colour of the floor is uniform and
// known, whatever has another colour is an obstacle; "its location determined through a geometric
// transformation": the ray of the lowest such pixel meets the plane of the floor. X_RF is the pose
// of the camera on the robot; points are in R. Directions whose first pixel is already no floor end
// there: what is there is nearer than the picture shows.
//
// Deviation: not along the picture's columns, but along lines away from the point below the camera.
// The camera looks down, so that upright edges lean outward in its picture: a column beside an
// object's foot may cross its top, which would be taken for an obstacle far behind it.
std::vector<FloorColumn> FloorObstacles(const cv::Mat& not_floor,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF,
                                        const FloorObstacleOptions& options);

// The same of one direction whose floor was seen from one pixel to another; nothing where these do
// not look at floor within the range.
std::optional<FloorColumn> FloorBetween(const Eigen::Vector2d& begin_px,
                                        const Eigen::Vector2d& end_px, bool obstacle,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF, double max_range_m);

// Whether the learning patch is free of what the sonar heard: no wall that would answer with these
// echoes (each a line across its sensor's axis) cuts it. Points are in R. Without this a wall that
// fills the picture would be learned as floor.
bool PatchIsFree(std::span<const Eigen::Vector2d> echoes_R_m, const FloorObstacleOptions& options);

// Learns the floor's colour from the patch in front of the robot: medians of shares and brightness,
// the tolerances of `prior`. No answer when the patch does not look like one floor, or like a floor
// that is too unlike the prior one (something stands in front of the robot).
std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const FloorObstacleOptions& options);

}  // namespace geon::navigation
