#pragma once

#include <ceres/rotation.h>

#include <Eigen/Core>

#include "calibration/rig_observations.h"
#include "calibration/rig_unknowns.h"
#include "geometry/sensor_rig.h"

namespace geon::calibration {

// The rig's geometry as Ceres differentiates it: the same as SensorRig, PinholeCamera and RigFrom
// (tests hold them together), over numbers T that carry derivatives. Unknowns are the blocks of
// RigUnknowns; `angles` are the head's true pan and tilt, `board` is the pose of the board in P: a
// rotation vector and a position.
template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

template <typename T>
Vector3<T> Turned(const T* rotation_vector, const Vector3<T>& p) {
  Vector3<T> turned;
  ceres::AngleAxisRotatePoint(rotation_vector, p.data(), turned.data());
  return turned;
}
template <typename T>
Vector3<T> TurnedBack(const T* rotation_vector, const Vector3<T>& p) {
  const T opposite[3] = {-rotation_vector[0], -rotation_vector[1], -rotation_vector[2]};
  return Turned(opposite, p);
}

// A direction or the difference of two points, from P to T: R_PT^-1, with R_PT = Rz(pan) Rx(roll)
// Ry(-tilt) Rx(-roll).
template <typename T>
Vector3<T> DirectionInHead(const T* axes, const T* angles, const Vector3<T>& v_P) {
  const T zero(0.0);
  const T pan[3] = {zero, zero, angles[0]};
  const T roll[3] = {axes[0], zero, zero};
  const T tilt[3] = {zero, -angles[1], zero};
  return Turned(roll, TurnedBack(tilt, TurnedBack(roll, TurnedBack(pan, v_P))));
}
// A point, from P to T: the pan axis passes through P's origin, the tilt axis ahead of it.
template <typename T>
Vector3<T> PointInHead(const T* axes, const T* angles, const Vector3<T>& p_P) {
  const T zero(0.0);
  const T pan[3] = {zero, zero, angles[0]};
  const Vector3<T> tilt_axis(axes[1], zero, zero);
  const T still[2] = {zero, angles[1]};
  return tilt_axis + DirectionInHead(axes, still, Vector3<T>(TurnedBack(pan, p_P) - tilt_axis));
}

template <typename T>
Eigen::Matrix<T, 2, 1> PixelOf(const geometry::PinholeCamera& drawn, const T* lens,
                               const Vector3<T>& p_C) {
  const T x = p_C[0] / p_C[2];
  const T y = p_C[1] / p_C[2];
  const T r2 = x * x + y * y;
  const T stretch = 1.0 + r2 * (drawn.k1_1 + lens[4] + r2 * (drawn.k2_1 + lens[5]));
  return {drawn.cx_px + lens[2] + (drawn.fx_px + lens[0]) * (x * stretch),
          drawn.cy_px + lens[3] + (drawn.fy_px + lens[0]) * (1.0 + lens[1]) * (y * stretch)};
}

template <typename T>
Vector3<T> RayOf(const geometry::PinholeCamera& drawn, const T* lens,
                 const Eigen::Vector2d& pixel_px) {
  const T x_seen = (pixel_px.x() - drawn.cx_px - lens[2]) / (drawn.fx_px + lens[0]);
  const T y_seen =
      (pixel_px.y() - drawn.cy_px - lens[3]) / ((drawn.fy_px + lens[0]) * (1.0 + lens[1]));
  T x = x_seen;
  T y = y_seen;
  constexpr int kRounds = 8;  // as PinholeCamera::Ray
  for (int round = 0; round < kRounds; ++round) {
    const T r2 = x * x + y * y;
    const T stretch = 1.0 + r2 * (drawn.k1_1 + lens[4] + r2 * (drawn.k2_1 + lens[5]));
    x = x_seen / stretch;
    y = y_seen / stretch;
  }
  return {x, y, T(1.0)};
}

// From T into a camera (`X_TC` as drawn, `mount` its unknowns), and a ray of it in T.
template <typename T>
Vector3<T> PointInCamera(const geometry::RigidTransform& X_TC, const T* mount,
                         const Vector3<T>& p_T) {
  const Vector3<T> p_TC_m = X_TC.translation().cast<T>() + Vector3<T>(mount + 3);
  const Vector3<T> drawn_C = X_TC.linear().transpose().cast<T>() * (p_T - p_TC_m);
  return TurnedBack(mount, drawn_C);
}
template <typename T>
Vector3<T> RayInHead(const geometry::RigidTransform& X_TC, const T* mount,
                     const Vector3<T>& ray_C) {
  return X_TC.linear().cast<T>() * Turned(mount, ray_C);
}

// How far in front of a laser's plane (on the side of its normal) a point of T lies, metres.
template <typename T>
T HeightOverFan(const geometry::LaserMount& drawn, const LaserAxes& axes, const T* laser,
                const Vector3<T>& p_T) {
  const Eigen::Vector3d& normal = drawn.normal_T;
  const Vector3<T> turned_normal = normal.cast<T>() +
                                   laser[0] * axes.beam_T.cross(normal).cast<T>() +
                                   laser[1] * axes.stripe_T.cross(normal).cast<T>();
  const Vector3<T> origin_T = drawn.p_TLaser_m.cast<T>() + laser[2] * normal.cast<T>();
  return turned_normal.dot(p_T - origin_T) / turned_normal.norm();
}

// Where the ray through a pixel of the B/W camera meets the board, in T.
template <typename T>
Vector3<T> BoardPointInHead(const geometry::SensorRig& drawn, const T* lens, const T* mount,
                            const T* axes, const T* angles, const T* board,
                            const Eigen::Vector2d& pixel_px) {
  const Vector3<T> normal_P = Turned(board, Vector3<T>(Eigen::Vector3d::UnitZ().cast<T>()));
  const Vector3<T> normal_T = DirectionInHead(axes, angles, normal_P);
  const Vector3<T> corner_T = PointInHead(axes, angles, Vector3<T>(board[3], board[4], board[5]));
  const Vector3<T> eye_T = drawn.X_TB.translation().cast<T>() + Vector3<T>(mount + 3);
  const Vector3<T> ray_T = RayInHead(drawn.X_TB, mount, RayOf(drawn.stripe_camera, lens, pixel_px));
  return eye_T + ray_T * (normal_T.dot(corner_T - eye_T) / normal_T.dot(ray_T));
}

}  // namespace geon::calibration
