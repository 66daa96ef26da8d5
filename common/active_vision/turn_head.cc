#include "active_vision/turn_head.h"

#include <cmath>

#include "base/angles.h"

namespace geon::active_vision {
namespace {

// The solution of a cos(x) + b sin(x) = c nearest to x0.
std::optional<double> SolveNearest(double a, double b, double c, double x0_rad) {
  const double amplitude = std::hypot(a, b);
  if (amplitude <= 0.0 || std::abs(c) > amplitude) return std::nullopt;
  const double phase_rad = std::atan2(b, a);
  const double spread_rad = std::acos(c / amplitude);
  const double one_rad = WrapAngle(phase_rad + spread_rad - x0_rad);
  const double other_rad = WrapAngle(phase_rad - spread_rad - x0_rad);
  return x0_rad + (std::abs(one_rad) < std::abs(other_rad) ? one_rad : other_rad);
}

}  // namespace

// With q the point turned back by the pan, p_T = RotationAboutY(tilt) q, so that
// n . p_T = (nx qx + nz qz) cos(tilt) + (nx qz - nz qx) sin(tilt) + ny qy.
std::optional<HeadAngles> TiltPlaneToPoint(const Eigen::Vector3d& p_P_m,
                                           const Eigen::Vector3d& p_TOrigin_m,
                                           const Eigen::Vector3d& normal_T,
                                           const HeadAngles& head) {
  const Eigen::Vector3d q = geometry::RotationAboutZ(-head.pan_rad) * p_P_m;
  const Eigen::Vector3d& n = normal_T;
  const auto tilt_rad = SolveNearest(n.x() * q.x() + n.z() * q.z(), n.x() * q.z() - n.z() * q.x(),
                                     n.dot(p_TOrigin_m) - n.y() * q.y(), head.tilt_rad);
  if (!tilt_rad) return std::nullopt;
  return HeadAngles{head.pan_rad, *tilt_rad};
}

// With m the normal turned back by the tilt, n . p_T = m . RotationAboutZ(-pan) p_P.
std::optional<HeadAngles> PanPlaneToPoint(const Eigen::Vector3d& p_P_m,
                                          const Eigen::Vector3d& p_TOrigin_m,
                                          const Eigen::Vector3d& normal_T, const HeadAngles& head) {
  const Eigen::Vector3d m = geometry::RotationAboutY(-head.tilt_rad) * normal_T;
  const Eigen::Vector3d& p = p_P_m;
  const auto pan_rad = SolveNearest(m.x() * p.x() + m.y() * p.y(), m.x() * p.y() - m.y() * p.x(),
                                    normal_T.dot(p_TOrigin_m) - m.z() * p.z(), head.pan_rad);
  if (!pan_rad) return std::nullopt;
  return HeadAngles{*pan_rad, head.tilt_rad};
}

std::optional<HeadAngles> AimCamera(const Eigen::Vector3d& p_P_m,
                                    const geometry::RigidTransform& X_TCamera,
                                    const HeadAngles& head) {
  constexpr int kMaxRounds = 20;
  constexpr double kClose_rad = 1e-9;
  const Eigen::Vector3d right_T =
      X_TCamera.linear().col(0);  // normal of the plane of the middle column
  const Eigen::Vector3d down_T = X_TCamera.linear().col(1);  // and of the middle row
  const Eigen::Vector3d p_TCamera_m = X_TCamera.translation();
  HeadAngles aimed = head;
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto panned = PanPlaneToPoint(p_P_m, p_TCamera_m, right_T, aimed);
    if (!panned) return std::nullopt;
    const auto tilted = TiltPlaneToPoint(p_P_m, p_TCamera_m, down_T, *panned);
    if (!tilted) return std::nullopt;
    const double change_rad =
        std::abs(tilted->pan_rad - aimed.pan_rad) + std::abs(tilted->tilt_rad - aimed.tilt_rad);
    aimed = *tilted;
    if (change_rad < kClose_rad) return aimed;
  }
  return std::nullopt;
}

}  // namespace geon::active_vision
