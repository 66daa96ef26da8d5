#include "recognition/support_plane.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/angles.h"
#include "recognition/bw_camera.h"

namespace geon::recognition {
namespace {

constexpr double kReach_m = 0.03;        // points further from z = 0 are not support
constexpr double kReachWithin_m = 0.02;  // ... within the region of interest, where the target is
constexpr size_t kFewestOnSupport = 40;
constexpr double kTiltPrior_rad = RadiansFromDegrees(3.0);
constexpr double kOffsetPrior_m = 0.01;
constexpr double kPointSigma_m = 0.003;
constexpr double kCorrelated = 10.0;  // neighbouring points err alike: so many count as one
constexpr size_t kEnough = 200;       // of more candidates only every n-th is looked at
// Tukey's biweight shrinks from the spread of the candidates to that of a noisy plane.
constexpr std::array<double, 6> kTukey_m = {0.03, 0.02, 0.015, 0.012, 0.010, 0.010};

std::vector<Eigen::Vector3d> PointsNearSupport(const sensor::ScanSet& scan,
                                               const std::optional<VerticalRegion>& region) {
  const BwCamera camera = CameraAtTarget(scan);
  std::vector<Eigen::Vector3d> candidates;
  for (const sensor::RangeProfile& profile : scan.profiles) {
    for (const Eigen::Vector3d& p_L : profile.p_L_m) {
      if (std::abs(p_L.z()) > kReach_m) continue;
      const bool high = std::abs(p_L.z()) > kReachWithin_m;
      if (high && region && region->Holds(camera.InCamera(p_L))) continue;
      candidates.push_back(p_L);
    }
  }
  return candidates;
}

// Height of the plane z = c0 + c1 x + c2 y below a point; x and y from the middle.
double Above(const Eigen::Vector3d& plane, const Eigen::Vector3d& p_m) {
  return p_m.z() - plane.dot(Eigen::Vector3d(1.0, p_m.x(), p_m.y()));
}

// One step of reweighted least squares, each point counting as `count`.
Eigen::Vector3d Refit(const std::vector<Eigen::Vector3d>& points_m, const Eigen::Vector3d& plane,
                      double tukey_m, double count) {
  const Eigen::Vector3d prior(1.0 / std::pow(kOffsetPrior_m, 2), 1.0 / std::pow(kTiltPrior_rad, 2),
                              1.0 / std::pow(kTiltPrior_rad, 2));
  Eigen::Matrix3d information = prior.asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p_m : points_m) {
    const double share = Above(plane, p_m) / tukey_m;
    const double inside = 1.0 - share * share;
    if (inside <= 0.0) continue;
    const double weight = count * inside * inside / (kCorrelated * kPointSigma_m * kPointSigma_m);
    const Eigen::Vector3d row(1.0, p_m.x(), p_m.y());
    information += weight * row * row.transpose();
    right += weight * p_m.z() * row;
  }
  return information.ldlt().solve(right);
}

}  // namespace

std::optional<SupportPlane> FitSupportPlane(const sensor::ScanSet& scan,
                                            const std::optional<VerticalRegion>& region) {
  std::vector<Eigen::Vector3d> points_m = PointsNearSupport(scan, region);
  if (points_m.size() < kFewestOnSupport) return std::nullopt;
  const size_t every = (points_m.size() + kEnough - 1) / kEnough;
  for (size_t i = 0; i * every < points_m.size(); ++i) points_m[i] = points_m[i * every];
  points_m.resize((points_m.size() + every - 1) / every);
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p_m : points_m)
    middle_m += p_m / static_cast<double>(points_m.size());
  middle_m.z() = 0.0;
  for (Eigen::Vector3d& p_m : points_m) p_m -= middle_m;

  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  for (double tukey_m : kTukey_m) {
    plane = Refit(points_m, plane, tukey_m, static_cast<double>(every));
  }

  std::vector<double> off_m;
  for (const Eigen::Vector3d& p_m : points_m) {
    const double above_m = std::abs(Above(plane, p_m));
    if (above_m < kTukey_m.back()) off_m.push_back(above_m);
  }
  if (off_m.size() * every < kFewestOnSupport) return std::nullopt;
  const auto median = off_m.begin() + static_cast<std::ptrdiff_t>(off_m.size() / 2);
  std::nth_element(off_m.begin(), median, off_m.end());
  constexpr double kMedianOfMagnitude = 0.6745;  // of a normal variable, in sigmas
  return SupportPlane{middle_m + Eigen::Vector3d(0.0, 0.0, plane[0]),
                      Eigen::Vector3d(-plane[1], -plane[2], 1.0).normalized(),
                      *median / kMedianOfMagnitude, static_cast<int>(off_m.size() * every)};
}

geometry::RigidTransform LevelOn(const SupportPlane& plane) {
  const Eigen::Vector3d foot_m(plane.p_L_m.x(), plane.p_L_m.y(), 0.0);
  return Eigen::Translation3d(foot_m) *
         Eigen::Quaterniond::FromTwoVectors(plane.normal_L, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(-plane.p_L_m);
}

}  // namespace geon::recognition
