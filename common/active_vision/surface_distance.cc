#include "active_vision/surface_distance.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace geon::active_vision {
namespace {

constexpr size_t kFewestPoints = 10;
constexpr size_t kNearest = 15;   // whose median counts
constexpr double kAlong_1 = 0.3;  // how much the place along the stripe matters beside that across

struct SeenPoint {
  double away_1;  // in the picture from the wanted place, in units of the box
  double distance_m;
};

}  // namespace

std::optional<double> SurfaceDistance(const geometry::SensorRig& rig, const StripeTarget& target,
                                      double support_height_m,
                                      const std::vector<sensor::RangeProfile>& measured,
                                      sensor::Laser laser, double fraction) {
  const geometry::RigidTransform X_CL =
      geometry::ColorFromLevel(rig, target.head.pan_rad, target.head.tilt_rad, support_height_m);
  const bool horizontal = laser == sensor::Laser::kHorizontal;
  const Eigen::Vector2d wanted_1(horizontal ? 0.5 : fraction, horizontal ? fraction : 0.5);

  std::vector<SeenPoint> seen;
  for (const sensor::RangeProfile& profile : measured) {
    for (const Eigen::Vector3d& p_L_m : profile.p_L_m) {
      const Eigen::Vector3d p_C_m = X_CL * p_L_m;
      if (p_C_m.z() <= 0.0) continue;
      const Eigen::Vector2d pixel_px = rig.color_camera.Project(p_C_m);
      const Eigen::Vector2d place_1((pixel_px.x() - target.box.u_px) / target.box.w_px,
                                    (pixel_px.y() - target.box.v_px) / target.box.h_px);
      if ((place_1.array() < 0.0).any() || (place_1.array() > 1.0).any()) continue;
      Eigen::Vector2d away_1 = place_1 - wanted_1;
      away_1[horizontal ? 0 : 1] *= kAlong_1;
      seen.push_back({away_1.norm(), p_L_m.x()});
    }
  }
  if (seen.size() < kFewestPoints) return std::nullopt;
  const size_t count = std::min(kNearest, seen.size());
  std::partial_sort(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(count), seen.end(),
                    [](const SeenPoint& a, const SeenPoint& b) { return a.away_1 < b.away_1; });
  std::vector<double> nearest_m;
  for (size_t k = 0; k < count; ++k) nearest_m.push_back(seen[k].distance_m);
  return Median(std::move(nearest_m));
}

}  // namespace geon::active_vision
