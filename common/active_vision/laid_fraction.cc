#include "active_vision/laid_fraction.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/median.h"

namespace geon::active_vision {
namespace {

constexpr double kAboveSupport_m = 0.01;
constexpr double kMiddle_1 = 1.0 / 6.0;  // of the box, to either side of its middle
constexpr size_t kFewestInMiddle = 5;

}  // namespace

std::optional<double> LaidFraction(const sensor::RangeProfile& profile,
                                   const geometry::RigidTransform& X_CL,
                                   const geometry::PinholeCamera& color_camera,
                                   const sensor::PixelBox& box) {
  const bool horizontal = profile.laser == sensor::Laser::kHorizontal;
  std::vector<double> laid_1;
  for (const Eigen::Vector3d& p_L_m : profile.p_L_m) {
    const Eigen::Vector3d p_C_m = X_CL * p_L_m;
    if (p_L_m.z() < kAboveSupport_m || p_C_m.z() <= 0.0) continue;
    const Eigen::Vector2d pixel_px = color_camera.Project(p_C_m);
    const double from_left_1 = (pixel_px.x() + 0.5 - box.u_px) / box.w_px;
    const double from_top_1 = (pixel_px.y() + 0.5 - box.v_px) / box.h_px;
    if (std::abs((horizontal ? from_left_1 : from_top_1) - 0.5) > kMiddle_1) continue;
    const double laid = horizontal ? from_top_1 : from_left_1;
    if (laid > 0.0 && laid < 1.0) laid_1.push_back(laid);
  }
  if (laid_1.size() < kFewestInMiddle) return std::nullopt;
  return Median(std::move(laid_1));
}

}  // namespace geon::active_vision
