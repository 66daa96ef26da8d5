#include "calibration/fit_floor.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace geon::calibration {
namespace {

// The height a + b x + c y of the floor in R, with Cauchy weights.
Eigen::Vector3d FloorHeight(const std::vector<Eigen::Vector3d>& p_R_m, double noise_m) {
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  std::vector<double> weight_1(p_R_m.size(), 1.0);
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (size_t k = 0; k < p_R_m.size(); ++k) {
      const Eigen::Vector3d row(1.0, p_R_m[k].x(), p_R_m[k].y());
      normal += weight_1[k] * row * row.transpose();
      right += weight_1[k] * p_R_m[k].z() * row;
    }
    plane = normal.ldlt().solve(right);
    for (size_t k = 0; k < p_R_m.size(); ++k) {
      const double off =
          (p_R_m[k].z() - plane.dot(Eigen::Vector3d(1.0, p_R_m[k].x(), p_R_m[k].y()))) / noise_m;
      weight_1[k] = 1.0 / (1.0 + off * off);
    }
  }
  return plane;
}

// Of the points over the floor: the smaller of their two principal spreads.
double Spread_m(const std::vector<Eigen::Vector3d>& p_R_m) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : p_R_m) mean += p.head<2>();
  mean /= static_cast<double>(p_R_m.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& p : p_R_m) {
    scatter += (p.head<2>() - mean) * (p.head<2>() - mean).transpose();
  }
  const double smaller = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues().x();
  return 2.0 * std::sqrt(std::max(0.0, smaller) / static_cast<double>(p_R_m.size()));
}

}  // namespace

Result<FloorFit> FitFloor(const std::vector<FloorView>& views, const geometry::SensorRig& rig,
                          const FloorOptions& options) {
  std::vector<Eigen::Vector3d> p_R_m;
  for (const FloorView& view : views) {
    const geometry::RigidTransform X_RB = rig.StripeCameraPose(view.pan_rad, view.tilt_rad);
    for (const Eigen::Vector2d& pixel_px : view.horizontal_px) {
      const Eigen::Vector3d ray_B = rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y());
      const double depth_m = rig.DistanceToFan(rig.horizontal_laser, ray_B);
      if (depth_m > 0.0 && depth_m < 5.0) p_R_m.push_back(X_RB * (depth_m * ray_B));
    }
  }
  return FitFloorPoints(p_R_m, rig, options);
}

Result<FloorFit> FitFloorPoints(const std::vector<Eigen::Vector3d>& p_R_m,
                                const geometry::SensorRig& rig, const FloorOptions& options) {
  if (p_R_m.size() < static_cast<size_t>(options.min_points)) {
    return Status::Error("only " + std::to_string(p_R_m.size()) + " points of the floor, needed " +
                         std::to_string(options.min_points) +
                         ": lay the horizontal laser on bare floor at several tilts");
  }
  const double spread_m = Spread_m(p_R_m);
  if (spread_m < options.min_spread_m) {
    return Status::Error("the floor points lie on one line (" + std::to_string(spread_m) +
                         " m across it): take them at several tilts and pans");
  }
  const Eigen::Vector3d plane = FloorHeight(p_R_m, options.noise_m);
  FloorFit fit;
  fit.points = static_cast<int>(p_R_m.size());
  double sum = 0.0;
  for (const Eigen::Vector3d& p : p_R_m) {
    const double off = p.z() - plane.dot(Eigen::Vector3d(1.0, p.x(), p.y()));
    sum += std::min(off * off, 25.0 * options.noise_m * options.noise_m);
  }
  fit.rms_m = std::sqrt(sum / fit.points);
  const Eigen::Vector3d normal_R = Eigen::Vector3d(-plane[1], -plane[2], 1.0).normalized();
  const Eigen::Quaterniond upright =
      Eigen::Quaterniond::FromTwoVectors(normal_R, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d p_RP = rig.X_RP.translation();
  const double height_m =
      normal_R.z() * (p_RP.z() - plane.dot(Eigen::Vector3d(1.0, p_RP.x(), p_RP.y())));
  fit.X_RP = geometry::MakeTransform(upright.toRotationMatrix() * rig.X_RP.linear(),
                                     {p_RP.x(), p_RP.y(), height_m});
  fit.pitch_rad = std::atan(plane[1]);
  fit.roll_rad = std::atan(plane[2]);
  fit.height_m = height_m - p_RP.z();
  return fit;
}

}  // namespace geon::calibration
