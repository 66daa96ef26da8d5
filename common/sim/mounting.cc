#include "sim/mounting.h"

#include "sim/noise_source.h"

namespace geon::sim {
namespace {

// A small rotation about a random axis; each component has the given standard deviation.
Eigen::Matrix3d SmallRotation(double sigma_rad, NoiseSource* noise) {
  Eigen::Vector3d turn_rad;
  for (int k = 0; k < 3; ++k) turn_rad[k] = sigma_rad * noise->Gaussian();
  return Eigen::AngleAxisd(turn_rad.norm(), turn_rad.norm() > 0.0 ? turn_rad.normalized().eval()
                                                                  : Eigen::Vector3d::UnitX().eval())
      .toRotationMatrix();
}

void Misplace(const MountingErrorOptions& options, NoiseSource* noise,
              geometry::PinholeCamera* camera, geometry::RigidTransform* X_AC) {
  const double scale = 1.0 + options.focal_1 * noise->Gaussian();
  camera->fx_px *= scale;
  camera->fy_px *= scale;
  X_AC->linear() = X_AC->linear() * SmallRotation(options.camera_rad, noise);
}

}  // namespace

geometry::SensorRig AsMounted(const geometry::SensorRig& designed,
                              const MountingErrorOptions& options) {
  NoiseSource noise(static_cast<uint64_t>(options.individual) ^ 0x6d6f756e74ULL);
  geometry::SensorRig rig = designed;
  Misplace(options, &noise, &rig.color_camera, &rig.X_TC);
  Misplace(options, &noise, &rig.stripe_camera, &rig.X_TB);
  Misplace(options, &noise, &rig.floor_camera, &rig.X_RF);
  for (geometry::LaserMount* laser : {&rig.horizontal_laser, &rig.vertical_laser}) {
    laser->normal_T = SmallRotation(options.laser_rad, &noise) * laser->normal_T;
  }
  return rig;
}

}  // namespace geon::sim
