#include "sim/mounting.h"

#include "sim/noise_source.h"

namespace geon::sim {
namespace {

using Eigen::Vector3d;
using geometry::RigidTransform;

// Each component has the given standard deviation.
Vector3d Scatter(double sigma, NoiseSource* noise) {
  Vector3d values;
  for (int k = 0; k < 3; ++k) values[k] = sigma * noise->Gaussian();
  return values;
}

// A small rotation about a random axis.
Eigen::Matrix3d SmallRotation(double sigma_rad, NoiseSource* noise) {
  const Vector3d turn_rad = Scatter(sigma_rad, noise);
  if (turn_rad.norm() == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
}

BuiltCamera Grind(const geometry::PinholeCamera& designed, const MountingErrorOptions& options,
                  NoiseSource* noise) {
  BuiltCamera camera;
  camera.ideal = designed;
  camera.ideal.k1_1 = camera.ideal.k2_1 = 0.0;
  const double scale = 1.0 + options.focal_1 * noise->Gaussian();
  camera.ideal.fx_px *= scale * (1.0 + options.aspect_1 * noise->Gaussian());
  camera.ideal.fy_px *= scale;
  camera.ideal.cx_px += options.principal_px * noise->Gaussian();
  camera.ideal.cy_px += options.principal_px * noise->Gaussian();
  camera.lens.middle_px = {camera.ideal.cx_px + options.principal_px * noise->Gaussian(),
                           camera.ideal.cy_px + options.principal_px * noise->Gaussian()};
  // Lenses of one kind are alike: most of the distortion is the design's.
  constexpr double kSpread_1 = 0.3;
  const double corner_px = options.lens_px * (1.0 + kSpread_1 * noise->Gaussian());
  const double radius_px = 0.5 * std::hypot(designed.width_px, designed.height_px);
  camera.lens.bend_1_px2 = -corner_px / std::pow(radius_px, 3);
  return camera;
}

RigidTransform Misplace(const RigidTransform& X_AC, const MountingErrorOptions& options,
                        NoiseSource* noise) {
  return geometry::MakeTransform(X_AC.linear() * SmallRotation(options.camera_rad, noise),
                                 X_AC.translation() + Scatter(options.camera_m, noise));
}

BuiltLaser Misplace(const geometry::LaserMount& designed, const MountingErrorOptions& options,
                    NoiseSource* noise) {
  BuiltLaser laser;
  laser.p_TLaser_m = designed.p_TLaser_m + Scatter(options.laser_m, noise);
  const Eigen::Matrix3d turn = SmallRotation(options.laser_rad, noise);
  const Vector3d ahead_T = Vector3d::UnitX();
  laser.normal_T = turn * designed.normal_T;
  laser.forward_T =
      turn * (ahead_T - ahead_T.dot(designed.normal_T) * designed.normal_T).normalized();
  laser.bow_1 = options.laser_bow_1 * noise->Gaussian();
  return laser;
}

}  // namespace

RigidTransform TurnAxis::Turn(double angle_rad) const {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle_rad, direction).toRotationMatrix();
  return geometry::MakeTransform(turn, point_m - turn * point_m);
}

BuiltRig AsBuilt(const geometry::SensorRig& designed, const MountingErrorOptions& options) {
  NoiseSource noise(static_cast<uint64_t>(options.individual) ^ 0x6d6f756e74ULL);
  BuiltRig rig;
  rig.X_RP = designed.X_RP;
  rig.color_camera = Grind(designed.color_camera, options, &noise);
  rig.stripe_camera = Grind(designed.stripe_camera, options, &noise);
  rig.floor_camera = Grind(designed.floor_camera, options, &noise);
  rig.X_TC = Misplace(designed.X_TC, options, &noise);
  rig.X_TB = Misplace(designed.X_TB, options, &noise);
  rig.X_RF = Misplace(designed.X_RF, options, &noise);
  rig.horizontal_laser = Misplace(designed.horizontal_laser, options, &noise);
  rig.vertical_laser = Misplace(designed.vertical_laser, options, &noise);
  rig.tilt_P.point_m = Scatter(options.axes_m, &noise);
  rig.tilt_P.direction = SmallRotation(options.axes_rad, &noise) * Vector3d::UnitY();
  rig.pan_zero_rad = options.zero_rad * noise.Gaussian();
  rig.tilt_zero_rad = options.zero_rad * noise.Gaussian();
  return rig;
}

}  // namespace geon::sim
