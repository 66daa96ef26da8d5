#include "sim/lamp_mirror.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "sim/lighting.h"

namespace geon::sim {
namespace {

constexpr float kSoftEdge_m = 0.1F;  // of the panel, inward and outward

// 1 well within the panel's side of this length, 0 well outside.
float Within(float off_middle_m, double side_m) {
  const float inside_m = static_cast<float>(0.5 * side_m) - std::abs(off_middle_m);
  return std::clamp(0.5F + 0.5F * inside_m / kSoftEdge_m, 0.0F, 1.0F);
}

}  // namespace

float MirroredLamp_1(const Eigen::Vector3f& p, const Eigen::Vector3f& eye,
                     const Eigen::Vector3f& lamp) {
  const float eye_up_m = eye.z() - p.z();
  if (eye_up_m <= 0.0F) return 0.0F;
  // Where the mirrored line of sight meets the ceiling, from the lamp's middle.
  const Eigen::Vector2f off_m = (p + (lamp.z() - p.z()) / eye_up_m * (p - eye) - lamp).head<2>();
  const float panel_1 = Within(off_m.x(), kLampPanel_m[0]) * Within(off_m.y(), kLampPanel_m[1]);
  if (panel_1 == 0.0F) return 0.0F;
  constexpr auto kPerHeight2_1_m2 = static_cast<float>(kPi / (kLampPanel_m[0] * kLampPanel_m[1]));
  return panel_1 * kPerHeight2_1_m2 * lamp.z() * lamp.z();
}

}  // namespace geon::sim
