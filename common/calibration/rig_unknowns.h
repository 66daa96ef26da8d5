#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "base/status.h"
#include "geometry/sensor_rig.h"

namespace geon::calibration {

// How far a robot may be from its drawing: standard deviations of the priors. Wide on purpose: they
// hold what the pictures cannot tell, and yield to what they can.
struct DrawingTolerances {
  double focal_1 = 0.03;    // of the focal length
  double aspect_1 = 0.005;  // of how far a pixel is from square
  double center_px = 20.0;
  double k1_1 = 0.2;
  double k2_1 = 1.0;
  double turn_rad = 0.02;     // of a camera or a laser
  double position_m = 0.005;  // of a camera or a laser
  double axis_rad = 0.01;     // of the pan-tilt unit's axes to each other
  double axis_m = 0.005;      // between them

  Status Validate() const;
};

// The unknowns of one rig: 32 differences from its drawing, all 0 for the drawing itself.
//
// What no view of a board can tell is fixed, not estimated (gauge freedoms): where the two axes'
// zeros are (T is P where both encoders say 0, so an offset of an encoder is part of the cameras'
// and lasers' poses), the height of P along the pan axis (that of the tilt axis: p_PTilt.z = 0),
// the place along the tilt axis (p_PTilt.y = 0), and the direction of x about the pan axis (square
// to the tilt axis: tilt_yaw = 0). A laser's plane has three unknowns; where in its plane the fan
// starts stays as drawn.
class RigUnknowns {
 public:
  enum Block { kStripeLens, kStripeMount, kColorLens, kColorMount, kAxes, kHorizontal, kVertical };
  static constexpr std::array<int, 7> kSize = {6, 6, 6, 6, 2, 3, 3};
  static constexpr int kAll = 32;

  static constexpr int Offset(Block block) {
    int offset = 0;
    for (int b = 0; b < block; ++b) offset += kSize[static_cast<size_t>(b)];
    return offset;
  }
  double* operator[](Block block) { return values_.data() + Offset(block); }
  const double* operator[](Block block) const { return values_.data() + Offset(block); }
  double& at(int k) { return values_[static_cast<size_t>(k)]; }
  double at(int k) const { return values_[static_cast<size_t>(k)]; }

 private:
  std::array<double, kAll> values_{};
};

// One unknown in words, for reports. `display_1` turns its SI value into `unit`.
struct UnknownName {
  std::string part;  // "B/W camera"
  std::string what;  // "focal length"
  std::string unit;  // "px", "mm", "deg" or "" for a pure number
  double display_1 = 1.0;
};
const std::array<UnknownName, RigUnknowns::kAll>& UnknownNames();

// Standard deviations of the priors, in the order of RigUnknowns.
std::array<double, RigUnknowns::kAll> PriorSigmas(const DrawingTolerances& tolerances,
                                                  const geometry::SensorRig& drawn);

// The rig that differs so from its drawing. X_RP, X_RF and the floor camera are the drawing's.
geometry::SensorRig RigFrom(const RigUnknowns& unknowns, const geometry::SensorRig& drawn);

// The two directions in a laser's plane about which its unknowns turn it: its beam, from where the
// fan starts forward, and its stripe. Orthonormal with the normal.
struct LaserAxes {
  Eigen::Vector3d beam_T;
  Eigen::Vector3d stripe_T;
};
LaserAxes AxesOf(const geometry::LaserMount& laser);

}  // namespace geon::calibration
