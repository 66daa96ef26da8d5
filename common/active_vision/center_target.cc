#include "active_vision/center_target.h"

#include <cmath>

#include "active_vision/turn_head.h"
#include "base/contracts.h"

namespace geon::active_vision {
namespace {

// Where along one image axis the view's middle should go, as a pixel: past the touched edge by
// `share` of the angle free at the other one; the middle itself when neither edge is touched.
double WantedCenter(bool touches_low, bool touches_high, double low_px, double high_px, int size_px,
                    double center_px, double focal_px, double share_1) {
  double angle_rad = 0.0;
  if (touches_high) angle_rad = AngleFromEdge(low_px, center_px, focal_px);
  if (touches_low) {
    const double last_px = size_px - 1.0;
    angle_rad = -(AngleFromEdge(last_px, center_px, focal_px) -
                  AngleFromEdge(high_px, center_px, focal_px));
  }
  return center_px + focal_px * std::tan(share_1 * angle_rad);
}

}  // namespace

double AngleFromEdge(double pixel_px, double center_px, double focal_px) {
  return std::atan((pixel_px - center_px) / focal_px) - std::atan(-center_px / focal_px);
}

CenteringStep CenterTarget(const geometry::SensorRig& rig, const sensor::PixelBox& box,
                           const HeadAngles& head, const HeadLimits& limits,
                           const CenteringOptions& options) {
  Require(box.w_px > 0 && box.h_px > 0, "CenterTarget: the box is empty");
  Require(options.step_fraction_1 > 0.0 && options.step_fraction_1 <= 1.0,
          "CenteringOptions: step_fraction_1 in (0, 1]");
  const geometry::PinholeCamera& camera = rig.color_camera;
  const int right_px = box.u_px + box.w_px - 1;
  const int bottom_px = box.v_px + box.h_px - 1;
  const bool left = box.u_px <= options.edge_px;
  const bool right = right_px >= camera.width_px - 1 - options.edge_px;
  const bool top = box.v_px <= options.edge_px;
  const bool bottom = bottom_px >= camera.height_px - 1 - options.edge_px;
  if ((left && right) || (top && bottom)) return {Centering::kTooLarge, head};
  if (!left && !right && !top && !bottom) return {Centering::kInView, head};

  const double u_px = WantedCenter(left, right, box.u_px, right_px, camera.width_px, camera.cx_px,
                                   camera.fx_px, options.step_fraction_1);
  const double v_px = WantedCenter(top, bottom, box.v_px, bottom_px, camera.height_px, camera.cy_px,
                                   camera.fy_px, options.step_fraction_1);
  // A direction, not a place: the camera turns, that it also moves by some centimetres is left
  // aside.
  geometry::RigidTransform X_TC = rig.X_TC;
  X_TC.translation().setZero();
  const Eigen::Vector3d direction_P = geometry::RotationAboutZ(head.pan_rad) *
                                      geometry::RotationAboutY(-head.tilt_rad) * X_TC.linear() *
                                      camera.Ray(u_px, v_px);
  const auto aimed = AimCamera(direction_P, X_TC, head);
  if (!aimed) return {Centering::kAtLimit, head};
  const HeadAngles reachable = limits.Clamp(*aimed);
  constexpr double kNoTurn_rad = 0.001;  // the unit's resolution is 0.9 mrad
  const bool turns = std::abs(reachable.pan_rad - head.pan_rad) > kNoTurn_rad ||
                     std::abs(reachable.tilt_rad - head.tilt_rad) > kNoTurn_rad;
  if (!turns) return {Centering::kAtLimit, head};
  return {Centering::kTurn, reachable};
}

}  // namespace geon::active_vision
