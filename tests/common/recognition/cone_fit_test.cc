#include "recognition/cone_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "base/angles.h"

namespace geon::recognition {
namespace {

struct Seen {
  std::vector<Eigen::Vector3d> points_m;
  std::vector<OrientedPoint> oriented;
};

// The half of a cone that faces -x, turned by `turn`, with `noise_m` on its 90 points and a few
// points of its flat end; 9 of them with normals.
Seen HalfCone(double slope_1, const Eigen::AngleAxisd& turn, double noise_m, uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss(0.0, noise_m);
  const Eigen::Vector3d shift_m(1.0, 0.1, 0.2);
  Seen seen;
  const auto add = [&](double s_m, double angle_rad, bool oriented) {
    const Eigen::Vector3d out(-std::cos(angle_rad), std::sin(angle_rad), 0.0);
    const Eigen::Vector3d p_m =
        (0.06 + slope_1 * s_m + gauss(random)) * out + s_m * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d normal = (out - slope_1 * Eigen::Vector3d::UnitZ()).normalized();
    seen.points_m.push_back(turn * p_m + shift_m);
    if (oriented) seen.oriented.push_back({seen.points_m.back(), turn * normal});
  };
  for (int i = -7; i <= 7; ++i) {
    for (int k = -1; k <= 1; ++k) {
      add(0.05 * k, 0.15 * i, i % 4 == 0);
      add(0.01 * i, 0.6 * k, false);
    }
  }
  for (int i = -4; i <= 4; ++i) {
    seen.points_m.push_back(turn * Eigen::Vector3d(-0.02, 0.01 * i, 0.08) + shift_m);
  }
  return seen;
}

TEST(FitCone, FindsAxisRadiusAndSlopeOfAnUprightAndALyingCone) {
  for (const Eigen::AngleAxisd& turn :
       {Eigen::AngleAxisd::Identity(),
        Eigen::AngleAxisd(RadiansFromDegrees(80.0), Eigen::Vector3d(1.0, 0.3, 0.0).normalized())}) {
    const Seen seen = HalfCone(0.2, turn, 0.0005);
    const Cone cone = FitCone(seen.points_m, seen.oriented, 0.002);
    EXPECT_LT(cone.misfit_1, 0.3);
    EXPECT_NEAR(std::abs(cone.axis_L.dot(turn * Eigen::Vector3d::UnitZ())), 1.0, 2e-3);
    EXPECT_NEAR(std::abs(cone.slope_1), 0.2, 0.03);
  }
}

TEST(FitCone, ACylinderHasNoSlope) {
  const Seen seen = HalfCone(0.0, Eigen::AngleAxisd::Identity(), 0.0005);
  const Cone cone = FitCone(seen.points_m, seen.oriented, 0.002);
  EXPECT_NEAR(cone.slope_1, 0.0, 0.02);
  EXPECT_NEAR(cone.radius_m, 0.06, 0.002);
}

TEST(FitCone, TellsHowFarTheSlopeMayBeOff) {
  constexpr int kFits = 200;
  double squares = 0.0, sigmas = 0.0;
  for (uint64_t seed = 1; seed <= kFits; ++seed) {
    const Seen seen = HalfCone(0.1, Eigen::AngleAxisd::Identity(), 0.0005, seed);
    const Cone cone = FitCone(seen.points_m, seen.oriented, 0.002);
    const double slope_1 = std::copysign(cone.slope_1, cone.slope_1 * cone.axis_L.z());
    squares += std::pow(slope_1 - 0.1, 2);
    sigmas += cone.slope_sigma_1;
  }
  EXPECT_NEAR(sigmas / kFits / std::sqrt(squares / kFits), 1.0, 0.3);
}

TEST(FitCone, OfTooFewPointsOrAPlaneSaysThatNothingFits) {
  EXPECT_EQ(FitCone({}, {}, 0.002).misfit_1, 1.0);
  std::vector<Eigen::Vector3d> plane_m;
  std::vector<OrientedPoint> oriented;
  for (int i = 0; i < 81; ++i) {
    plane_m.emplace_back(1.0, 0.01 * (i % 9), 0.01 * (i / 9));
    if (i % 9 == 4) oriented.push_back({plane_m.back(), -Eigen::Vector3d::UnitX()});
  }
  EXPECT_EQ(FitCone(plane_m, oriented, 0.002).misfit_1, 1.0) << "no two normals cross";
}

}  // namespace
}  // namespace geon::recognition
