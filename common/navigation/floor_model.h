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
//
// Source: thesis section 4.3, assumption (i): the colour of the floor is uniform and known.
// Deviation: it is refined from what the camera sees of free floor, since lamps differ.
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

// In the mask: what is brighter than the floor, and no more coloured than a lamp.
inline constexpr uint8_t kBrightMask = 128;

// 255 or kBrightMask where a pixel has the floor's colour in none of the lights that `models` tell
// of (at least one); specks and lines under 3 pixels are gone. `image_bgr` CV_8UC3.
cv::Mat NotFloorMask(const cv::Mat& image_bgr, std::span<const FloorModel> models);

// What sonar and infrared heard in their last round, to know where the ground is free.
struct RingEchoes {
  std::vector<Eigen::Vector2d> points_R_m;
  double moved_m = 0.0;  // how far places before the robot moved in R since the oldest of them
};

// A rectangle of the ground before the robot, frame R, sides along its axes.
struct FloorPatch {
  double near_m = 0.45, far_m = 0.85;     // x
  double right_m = -0.20, left_m = 0.20;  // y
};

// Whether no wall that would answer with these echoes (each a line across its sensor's axis) cuts
// the patch. Without this a wall that fills the picture would be learned as floor.
bool PatchIsFree(const RingEchoes& echoes, const FloorPatch& patch);

// Learns the floor's colour from what lies in a patch of the ground: medians of shares and
// brightness, the tolerances of `prior`. No answer when the patch does not look like one floor, or
// like a floor that is too unlike the prior one (something stands there), or is not in the picture.
std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const FloorPatch& patch);

// The same from the ground before the robot, of some patches, larger ones first: the first that is
// free and looks like one floor.
std::optional<FloorModel> LearnFloor(const cv::Mat& image_bgr,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_RF, const FloorModel& prior,
                                     const RingEchoes& echoes);

// The floor in two lights, shade and sun in this order, once ground of another light than the
// `known` one lies before the robot, all of a patch or a good part of it: what is free there,
// clearly brighter or darker, and no more coloured than lamp and sun make it. What is darker is
// floor in the shade only if the `known` floor is brighter by daylight, `prior` being its colour by
// lamps neither warm nor cold. What is brighter may be a lamp that a polished floor mirrors, which
// is as good as sun. The window of the sunlit floor's brightness is narrow below: a white wall in
// the shade has nearly its colour, and is a little brighter than floor in the shade.
std::optional<std::array<FloorModel, 2>> LearnOtherLight(const cv::Mat& image_bgr,
                                                         const geometry::PinholeCamera& camera,
                                                         const geometry::RigidTransform& X_RF,
                                                         const FloorModel& known,
                                                         const FloorModel& prior,
                                                         const RingEchoes& echoes);

}  // namespace geon::navigation
