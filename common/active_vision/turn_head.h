#pragma once

#include <Eigen/Core>
#include <optional>

#include "active_vision/head_angles.h"
#include "geometry/sensor_rig.h"

namespace geon::active_vision {

// Source: thesis section 4.2.4, derived from rigid transforms where 4.34-4.47 use single angles.
//
// The smallest turn about one axis that brings a point into a plane the head carries, such as a
// laser's, or one of the two planes through a camera's optical axis. In closed form: the plane's
// equation is a cos + b sin = c in the angle. Nothing when the plane passes the point by.
//
// p_P_m is the point in frame P; the plane is { p : normal_T . (p - p_TOrigin_m) = 0 } in frame T;
// `head` gives the angle that stays and the one to start from. Limits are the caller's affair.
std::optional<HeadAngles> TiltPlaneToPoint(const Eigen::Vector3d& p_P_m,
                                           const Eigen::Vector3d& p_TOrigin_m,
                                           const Eigen::Vector3d& normal_T, const HeadAngles& head);
std::optional<HeadAngles> PanPlaneToPoint(const Eigen::Vector3d& p_P_m,
                                          const Eigen::Vector3d& p_TOrigin_m,
                                          const Eigen::Vector3d& normal_T, const HeadAngles& head);

// The head angles that bring a point in frame P onto the optical axis of a camera mounted at
// X_TCamera, by turns of one axis and the other until they agree. Nothing when that leads nowhere.
std::optional<HeadAngles> AimCamera(const Eigen::Vector3d& p_P_m,
                                    const geometry::RigidTransform& X_TCamera,
                                    const HeadAngles& head);

}  // namespace geon::active_vision
