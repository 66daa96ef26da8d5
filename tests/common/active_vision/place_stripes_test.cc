#include "active_vision/place_stripes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/contracts.h"
#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

using sensor::Laser;

// The point of the target a stripe is wanted at, built in R: on the colour camera's ray through
// that fraction of the box, `distance_m` ahead of the B/W camera along the ground.
Eigen::Vector3d WantedPoint(const geometry::SensorRig& rig, const StripeTarget& target,
                            double from_left, double from_top) {
  const auto X_RC = rig.ColorCameraPose(target.head.pan_rad, target.head.tilt_rad);
  const auto X_RB = rig.StripeCameraPose(target.head.pan_rad, target.head.tilt_rad);
  const auto ray_R = [&](double left, double top) -> Eigen::Vector3d {
    return X_RC.linear() * rig.color_camera.Ray(target.box.u_px - 0.5 + left * target.box.w_px,
                                                target.box.v_px - 0.5 + top * target.box.h_px);
  };
  Eigen::Vector2d ahead = ray_R(0.5, 0.5).head<2>().normalized();
  const Eigen::Vector3d ray = ray_R(from_left, from_top);
  const double start_m = ahead.dot((X_RC.translation() - X_RB.translation()).head<2>());
  return X_RC.translation() + ray * ((target.distance_m - start_m) / ahead.dot(ray.head<2>()));
}

double DistanceFromLaserPlane(const geometry::SensorRig& rig, const sensor::PlannedStripe& stripe,
                              const Eigen::Vector3d& p_R_m) {
  const geometry::LaserMount& laser =
      stripe.laser == Laser::kHorizontal ? rig.horizontal_laser : rig.vertical_laser;
  const auto X_TR = rig.HeadPose(stripe.pan_rad, stripe.tilt_rad).inverse();
  return laser.normal_T.dot(X_TR * p_R_m - laser.p_TLaser_m);
}

TEST(PlaceStripesTest, LaserPlanesHoldThePointsAtTheQuartersOfTheTarget) {
  const geometry::SensorRig rig = TestRig();
  for (const double distance_m : {0.7, 0.95, 1.3, 1.9}) {
    for (const double pan_rad : {-0.6, 0.0, 0.5}) {
      const double tilt_rad = std::atan2(-1.2, distance_m) + RadiansFromDegrees(20.0);
      const StripeTarget target{{150, 100, 260, 300}, {pan_rad, tilt_rad}, distance_m};
      const StripePlacement placement = PlaceStripes(rig, target, {});
      ASSERT_TRUE(placement.complete());
      ASSERT_EQ(placement.stripes.size(), 6U);
      for (size_t k = 0; k < 6; ++k) {
        const sensor::PlannedStripe& stripe = placement.stripes[k];
        const bool horizontal = k < 3;
        EXPECT_EQ(stripe.laser, horizontal ? Laser::kHorizontal : Laser::kVertical);
        EXPECT_NEAR(stripe.fraction, 0.25 * static_cast<double>(k % 3 + 1), 1e-12);
        const Eigen::Vector3d p_R_m = horizontal ? WantedPoint(rig, target, 0.5, stripe.fraction)
                                                 : WantedPoint(rig, target, stripe.fraction, 0.5);
        EXPECT_NEAR(DistanceFromLaserPlane(rig, stripe, p_R_m), 0.0, 1e-9);
      }
    }
  }
}

TEST(PlaceStripesTest, HorizontalStripesAscendInTiltAndVerticalOnesInPan) {
  const auto stripes =
      PlaceStripes(TestRig(), {{200, 120, 200, 240}, {0.1, -0.5}, 1.0}, {}).stripes;
  ASSERT_EQ(stripes.size(), 6U);
  EXPECT_GT(stripes[0].tilt_rad, stripes[1].tilt_rad) << "the first stripe is the top one";
  EXPECT_GT(stripes[1].tilt_rad, stripes[2].tilt_rad);
  EXPECT_GT(stripes[3].pan_rad, stripes[4].pan_rad) << "the fourth stripe is the leftmost";
  EXPECT_GT(stripes[4].pan_rad, stripes[5].pan_rad);
}

TEST(PlaceStripesTest, StripesLieInTheViewOfTheStripeCamera) {
  const geometry::SensorRig rig = TestRig();
  for (const double distance_m : {0.7, 1.0, 1.5}) {
    const double tilt_rad = std::atan2(-1.2, distance_m) + RadiansFromDegrees(17.0);
    const StripeTarget target{{170, 40, 300, 400}, {0.2, tilt_rad}, distance_m};
    for (const sensor::PlannedStripe& stripe : PlaceStripes(rig, target, {}).stripes) {
      const bool horizontal = stripe.laser == Laser::kHorizontal;
      for (const double end : {0.05, 0.5, 0.95}) {
        const Eigen::Vector3d p_R_m = horizontal ? WantedPoint(rig, target, end, stripe.fraction)
                                                 : WantedPoint(rig, target, stripe.fraction, end);
        const Eigen::Vector3d p_B_m =
            rig.StripeCameraPose(stripe.pan_rad, stripe.tilt_rad).inverse() * p_R_m;
        EXPECT_TRUE(rig.stripe_camera.Contains(rig.stripe_camera.Project(p_B_m)))
            << distance_m << " m, stripe at " << stripe.fraction;
      }
    }
  }
}

// Printed formulas, as the errata correct them, for a level mount, small angles and devices near
// the axes; they leave aside that turning the head also carries the laser along.
TEST(PlaceStripesTest, TiltsAgreeWithThePrintedFormulas) {
  constexpr double kDistance_m = 1.6;
  constexpr double kAxis_m = 1.2;
  geometry::SensorRig rig = TestRig(0.0);
  rig.X_TC.translation().setZero();
  rig.X_TB.translation().setZero();
  const double laser_m = 0.125;
  const double rho_rad = std::atan(laser_m / 1.8);  // below the optical axis
  rig.horizontal_laser.p_TLaser_m = {0.0, 0.0, laser_m};
  rig.horizontal_laser.normal_T = {std::sin(rho_rad), 0.0, std::cos(rho_rad)};

  const double phi_rad = RadiansFromDegrees(32.0);
  const StripeTarget target{{260, 180, 120, 180}, {0.0, -phi_rad}, 0.0};
  // Point p, the bottom of the box, at the distance the box was measured at.
  const double bottom_rad = phi_rad + std::atan((359.5 - 239.5) / 1600.0);
  const double height_m = kAxis_m - kDistance_m * std::tan(bottom_rad);  // of p
  StripeTarget at_distance = target;
  at_distance.distance_m = kDistance_m;
  const auto placement = PlaceStripes(rig, at_distance, {});
  ASSERT_TRUE(placement.complete());

  const double beta_1_rad =
      std::atan((kAxis_m - height_m + laser_m * std::cos(phi_rad)) /
                (kDistance_m - laser_m * std::sin(phi_rad)));                  // (4.34), errata
  const double beta_2_rad = phi_rad + rho_rad;                                 // (4.35)
  const double delta_rad = beta_2_rad - beta_1_rad;                            // (4.36)
  const double theta_y_rad = 180.0 / 480.0 * 2.0 * std::atan(240.0 / 1600.0);  // (4.33)
  for (size_t k = 0; k < 3; ++k) {
    const double theta_h_rad = (0.75 - 0.25 * static_cast<double>(k)) * theta_y_rad;  // (4.30-4.32)
    EXPECT_NEAR(placement.stripes[k].tilt_rad, -phi_rad + delta_rad + theta_h_rad,
                RadiansFromDegrees(0.4))
        << k;
  }
}

TEST(PlaceStripesTest, PansAgreeWithThePrintedFormulas) {
  constexpr double d = 1.6;  // distance, as in the thesis
  constexpr double d_v = 0.125;
  constexpr double kTanRho = d_v / 1.8;
  geometry::SensorRig rig = TestRig(0.0);
  rig.X_TC.translation().setZero();
  rig.X_TB.translation().setZero();
  rig.vertical_laser.p_TLaser_m = {0.0, d_v, 0.0};
  rig.vertical_laser.normal_T = Eigen::Vector3d(kTanRho, 1.0, 0.0).normalized();
  // From 100 px left of the optical axis to the axis itself.
  const StripeTarget target{{220, 190, 100, 100}, {0.0, 0.0}, d};
  const auto placement = PlaceStripes(rig, target, {});
  ASSERT_TRUE(placement.complete());

  const double rho_rad = std::atan(kTanRho);
  const double tan_theta_1 = 100.0 / 1600.0;
  const double d_2 = d_v / kTanRho - d;                              // (4.38)
  const double c = d_2 * kTanRho - d * tan_theta_1;                  // (4.39)
  const double g = d * kTanRho;                                      // (4.40)
  const double f = g + c;                                            // (4.41)
  const double phi_rad = std::atan(f / d) - rho_rad;                 // (4.42)
  const double psi_rad = std::atan(d / d_v);                         // (4.43)
  const double delta_rad = kPi / 2.0 - rho_rad - phi_rad - psi_rad;  // (4.44)
  for (size_t k = 0; k < 3; ++k) {
    const double clockwise_rad = phi_rad + 0.25 * static_cast<double>(k + 1) * delta_rad;
    EXPECT_NEAR(placement.stripes[3 + k].pan_rad, -clockwise_rad, RadiansFromDegrees(0.1)) << k;
  }
}

TEST(PlaceStripesTest, StripesBeyondTheLimitsAreReported) {
  const StripeTarget target{{200, 120, 200, 240}, {0.0, -0.5}, 1.0};
  const auto all = PlaceStripes(TestRig(), target, {});
  ASSERT_EQ(all.stripes.size(), 6U);
  HeadLimits limits;
  limits.tilt_min_rad = 0.5 * (all.stripes[1].tilt_rad + all.stripes[2].tilt_rad);
  const auto some = PlaceStripes(TestRig(), target, limits);
  EXPECT_FALSE(some.complete());
  ASSERT_EQ(some.unreachable.size(), 1U);
  EXPECT_EQ(some.unreachable[0].laser, Laser::kHorizontal);
  EXPECT_NEAR(some.unreachable[0].fraction, 0.75, 1e-12);
  EXPECT_NEAR(some.unreachable[0].tilt_rad, limits.tilt_min_rad, 1e-12) << "as near as it gets";
  EXPECT_EQ(some.stripes.size(), 5U);
}

TEST(PlaceStripesTest, OtherFractionsCanBeAskedFor) {
  StripePlacementOptions options;
  options.fractions_1 = {0.1, 0.5, 0.9};
  const StripeTarget target{{200, 120, 200, 240}, {0.0, -0.5}, 1.0};
  const geometry::SensorRig rig = TestRig();
  const auto placement = PlaceStripes(rig, target, {}, options);
  EXPECT_NEAR(DistanceFromLaserPlane(rig, placement.stripes[0], WantedPoint(rig, target, 0.5, 0.1)),
              0.0, 1e-9);
}

TEST(PlaceStripesTest, BrokenContractsThrow) {
  EXPECT_THROW(PlaceStripes(TestRig(), {{0, 0, 0, 10}, {}, 1.0}, {}), ContractViolation);
  EXPECT_THROW(PlaceStripes(TestRig(), {{0, 0, 10, 10}, {}, 0.0}, {}), ContractViolation);
}

}  // namespace
}  // namespace geon::active_vision
