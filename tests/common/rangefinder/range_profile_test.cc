#include "rangefinder/range_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/active_vision/test_rig.h"
#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

using geometry::RigidTransform;
using sensor::Laser;

struct Plane {
  Eigen::Vector3d normal;
  double offset_m = 0.0;  // normal . p = offset_m
};

// Where in a column (row) of the B/W camera the laser's plane and another one meet, all in frame B.
std::optional<double> StripeOnPlane(const geometry::SensorRig& rig, Laser laser, const Plane& plane,
                                    int line) {
  const bool horizontal = laser == Laser::kHorizontal;
  const geometry::LaserMount& mount = horizontal ? rig.horizontal_laser : rig.vertical_laser;
  const RigidTransform X_BT = rig.X_TB.inverse();
  const Eigen::Vector3d laser_normal = X_BT.linear() * mount.normal_T;
  const double laser_offset_m = laser_normal.dot(X_BT * mount.p_TLaser_m);
  const geometry::PinholeCamera& camera = rig.stripe_camera;
  // The plane of camera centre and image line.
  const Eigen::Vector3d line_normal =
      horizontal ? camera.Ray(line, 0.0).cross(camera.Ray(line, 1.0)).eval()
                 : camera.Ray(0.0, line).cross(camera.Ray(1.0, line)).eval();
  Eigen::Matrix3d rows;
  rows << laser_normal.transpose(), plane.normal.transpose(), line_normal.transpose();
  const Eigen::Vector3d p_B_m =
      rows.inverse() * Eigen::Vector3d(laser_offset_m, plane.offset_m, 0.0);
  if (p_B_m.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d pixel_px = camera.Project(p_B_m);
  return horizontal ? pixel_px.y() : pixel_px.x();
}

LookUpTable Calibrate(const geometry::SensorRig& rig, Laser laser) {
  std::vector<BoardObservation> boards;
  for (int k = 0; k < 281; ++k) {
    BoardObservation board;
    board.distance_m = 0.65 + 0.005 * k;
    const int lines = laser == Laser::kHorizontal ? 640 : 480;
    for (int line = 0; line < lines; ++line) {
      const Plane plane{Eigen::Vector3d::UnitZ(), board.distance_m};
      board.peaks.push_back(
          {line, PeakReason::kFound, StripeOnPlane(rig, laser, plane, line).value(), 100.0, 2.0});
    }
    boards.push_back(std::move(board));
  }
  return BuildLookUpTable(laser, 640, 480, 10, "2026-01-31", boards).value().table;
}

struct Scan {
  geometry::SensorRig rig = active_vision::TestRig();
  sensor::ScanPlan plan;
  sensor::Stripe stripe;
};

// A floor, seen with the head at other angles than those that define L.
Scan FloorScan(Laser laser) {
  Scan scan;
  scan.plan.pan_rad = 0.2;
  scan.plan.tilt_rad = RadiansFromDegrees(-30.0);
  scan.plan.stripes = {{laser, 0.25, 0.25, RadiansFromDegrees(-28.0)},
                       {laser, 0.5, 0.3, RadiansFromDegrees(-33.0)}};
  scan.stripe.scan_id = 7;
  scan.stripe.stripe_index = 1;
  scan.stripe.attempt = 2;
  scan.stripe.utime = 12345;
  scan.stripe.laser = laser;
  scan.stripe.pan_rad = 0.301;
  scan.stripe.tilt_rad = RadiansFromDegrees(-33.05);

  const RigidTransform X_RB = scan.rig.StripeCameraPose(scan.stripe.pan_rad, scan.stripe.tilt_rad);
  Plane floor;
  floor.normal = X_RB.linear().transpose() * Eigen::Vector3d::UnitZ();
  floor.offset_m = -X_RB.translation().z();
  SyntheticStripe synthetic;
  synthetic.laser = laser;
  synthetic.position_px = [&](int line) { return StripeOnPlane(scan.rig, laser, floor, line); };
  scan.stripe.difference = synthetic.Render();
  return scan;
}

TEST(RangeProfileTest, StripeOnTheFloorMeasuresTheFloor) {
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const Scan scan = FloorScan(laser);
    const auto profile =
        MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, laser), scan.rig);
    const size_t lines = laser == Laser::kHorizontal ? 640 : 480;
    EXPECT_GT(profile.pixel.size(), lines - 40);
    ASSERT_EQ(profile.pixel.size(), profile.p_L_m.size());
    double square_sum = 0.0;
    for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
      square_sum += profile.p_L_m[i].z() * profile.p_L_m[i].z();
      EXPECT_NEAR(profile.p_L_m[i].z(), 0.0, 0.003);
      if (i > 0) {
        EXPECT_GT(profile.pixel[i], profile.pixel[i - 1]);
      }
    }
    EXPECT_LT(std::sqrt(square_sum / static_cast<double>(profile.p_L_m.size())), 0.0005);
  }
}

TEST(RangeProfileTest, PointsLieInTheLasersPlaneWhereTheHeadHeldIt) {
  const Scan scan = FloorScan(Laser::kVertical);
  const auto profile =
      MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, Laser::kVertical), scan.rig);
  const RigidTransform X_RL =
      geometry::LevelFrame(scan.rig.StripeCameraPose(scan.plan.pan_rad, scan.plan.tilt_rad), 0.0);
  const RigidTransform X_TL =
      scan.rig.HeadPose(scan.stripe.pan_rad, scan.stripe.tilt_rad).inverse() * X_RL;
  const geometry::LaserMount& laser = scan.rig.vertical_laser;
  for (const Eigen::Vector3d& p_L_m : profile.p_L_m) {
    EXPECT_NEAR(laser.normal_T.dot(X_TL * p_L_m - laser.p_TLaser_m), 0.0, 5e-4);
  }
  EXPECT_NEAR((X_TL * profile.laser_origin_L_m.value() - laser.p_TLaser_m).norm(), 0.0, 1e-9);
  EXPECT_NEAR((X_TL.linear() * profile.rotation_LB.value() - scan.rig.X_TB.linear()).norm(), 0.0,
              1e-9);
}

TEST(RangeProfileTest, ProfileNamesItsStripe) {
  const Scan scan = FloorScan(Laser::kHorizontal);
  const auto profile =
      MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, Laser::kHorizontal), scan.rig);
  EXPECT_EQ(profile.scan_id, 7);
  EXPECT_EQ(profile.stripe_index, 1);
  EXPECT_EQ(profile.attempt, 2);
  EXPECT_EQ(profile.utime, 12345);
  EXPECT_EQ(profile.fraction, 0.5);
  EXPECT_EQ(profile.laser, Laser::kHorizontal);
}

TEST(RangeProfileTest, SupportHeightMovesTheLevelFrame) {
  Scan scan = FloorScan(Laser::kHorizontal);
  scan.plan.support_height_m = 0.1;
  const auto profile =
      MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, Laser::kHorizontal), scan.rig);
  EXPECT_NEAR(profile.p_L_m[300].z(), -0.1, 0.003);
}

TEST(RangeProfileTest, DarkStripeGivesNoPoints) {
  Scan scan = FloorScan(Laser::kHorizontal);
  std::fill(scan.stripe.difference.data.begin(), scan.stripe.difference.data.end(), uint8_t{2});
  const auto profile =
      MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, Laser::kHorizontal), scan.rig);
  EXPECT_TRUE(profile.pixel.empty());
}

// Where the stripe on the floor is seen by a camera with a lens: points of the line in which the
// laser's plane cuts the floor, projected one by one, and joined between columns.
std::function<std::optional<double>(int)> FloorStripeThroughLens(const geometry::SensorRig& rig,
                                                                 const sensor::Stripe& stripe) {
  const bool horizontal = stripe.laser == Laser::kHorizontal;
  const geometry::LaserMount& mount = horizontal ? rig.horizontal_laser : rig.vertical_laser;
  const RigidTransform X_RT = rig.HeadPose(stripe.pan_rad, stripe.tilt_rad);
  const RigidTransform X_BR = (X_RT * rig.X_TB).inverse();
  const Eigen::Vector3d normal_R = X_RT.linear() * mount.normal_T,
                        origin_R_m = X_RT * mount.p_TLaser_m;
  // Along the line: at right angles to both normals, through the point that is nearest the laser.
  const Eigen::Vector3d along_R = normal_R.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d down_R = along_R.cross(normal_R);
  const Eigen::Vector3d foot_R_m = origin_R_m - down_R * (origin_R_m.z() / down_R.z());
  const geometry::PinholeCamera& camera = rig.stripe_camera;
  std::vector<Eigen::Vector2d> seen_px;  // (column, row), or (row, column) of a vertical stripe
  for (double t_m = -1.5; t_m <= 1.5; t_m += 1e-4) {
    const Eigen::Vector3d p_B_m = X_BR * (foot_R_m + t_m * along_R);
    if (p_B_m.z() < 0.1) continue;
    const double x = p_B_m.x() / p_B_m.z(), y = p_B_m.y() / p_B_m.z(), r2 = x * x + y * y;
    if (r2 > 0.2) continue;  // far beyond the picture
    const double stretch = 1.0 + camera.k1_1 * r2 + camera.k2_1 * r2 * r2;
    const Eigen::Vector2d pixel_px(camera.cx_px + camera.fx_px * x * stretch,
                                   camera.cy_px + camera.fy_px * y * stretch);
    seen_px.push_back(horizontal ? pixel_px : Eigen::Vector2d(pixel_px.y(), pixel_px.x()));
  }
  std::sort(seen_px.begin(), seen_px.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return [seen_px](int line) -> std::optional<double> {
    const auto after = std::lower_bound(seen_px.begin(), seen_px.end(), line,
                                        [](const auto& p, int at) { return p.x() < at; });
    if (after == seen_px.begin() || after == seen_px.end()) return std::nullopt;
    const Eigen::Vector2d &a = *(after - 1), &b = *after;
    return a.y() + (line - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
  };
}

TEST(TriangulateStripeTest, MeasuresTheFloorThroughALensAndWithAxesOutOfSquare) {
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    Scan scan = FloorScan(laser);
    geometry::SensorRig& rig = scan.rig;
    rig.stripe_camera.k1_1 = -0.12;
    rig.stripe_camera.k2_1 = 0.4;
    rig.stripe_camera.cx_px += 7.0;
    rig.ptu_axes.tilt_roll_rad = 0.004;
    rig.ptu_axes.p_PTilt_m = {0.003, 0.0, -0.002};
    rig.vertical_laser.normal_T =
        (rig.vertical_laser.normal_T + Eigen::Vector3d(0.0, 0.0, 0.01)).normalized();
    SyntheticStripe synthetic;
    synthetic.laser = laser;
    synthetic.position_px = FloorStripeThroughLens(rig, scan.stripe);
    scan.stripe.difference = synthetic.Render();
    const auto profile = TriangulateStripe(scan.stripe, scan.plan, rig);
    EXPECT_GT(profile.pixel.size(), laser == Laser::kHorizontal ? 600u : 440u);
    double sum_m = 0.0, square_sum_m2 = 0.0;
    for (const Eigen::Vector3d& p_L_m : profile.p_L_m) {
      sum_m += p_L_m.z();
      square_sum_m2 += p_L_m.z() * p_L_m.z();
    }
    const auto n = static_cast<double>(profile.p_L_m.size());
    EXPECT_NEAR(sum_m / n, 0.0, 5e-5);
    EXPECT_LT(std::sqrt(square_sum_m2 / n), 5e-4);
    EXPECT_EQ(profile.stripe_index, 1);
  }
}

TEST(TriangulateStripeTest, AgreesWithATableOfTheSameRig) {
  const Scan scan = FloorScan(Laser::kVertical);
  const auto by_table =
      MeasureProfile(scan.stripe, scan.plan, Calibrate(scan.rig, Laser::kVertical), scan.rig);
  const auto by_rig = TriangulateStripe(scan.stripe, scan.plan, scan.rig);
  ASSERT_EQ(by_table.pixel, by_rig.pixel);
  for (size_t k = 0; k < by_rig.p_L_m.size(); ++k) {
    EXPECT_NEAR((by_rig.p_L_m[k] - by_table.p_L_m[k]).norm(), 0.0, 1e-4);  // the table's chords
  }
}

TEST(TriangulateStripeTest, LeavesOutWhatLiesOutsideItsDistances) {
  const Scan scan = FloorScan(Laser::kVertical);
  const auto all = TriangulateStripe(scan.stripe, scan.plan, scan.rig);
  const RigidTransform X_RB = scan.rig.StripeCameraPose(scan.plan.pan_rad, scan.plan.tilt_rad);
  const RigidTransform X_BL =
      (scan.rig.StripeCameraPose(scan.stripe.pan_rad, scan.stripe.tilt_rad)).inverse() *
      geometry::LevelFrame(X_RB, 0.0);
  const double middle_m = (X_BL * all.p_L_m[all.p_L_m.size() / 2]).z();
  const auto near_half = TriangulateStripe(scan.stripe, scan.plan, scan.rig, {}, {0.3, middle_m});
  EXPECT_GT(near_half.pixel.size(), all.pixel.size() / 4);
  EXPECT_LT(near_half.pixel.size(), 3 * all.pixel.size() / 4);
  for (const Eigen::Vector3d& p_L_m : near_half.p_L_m) {
    EXPECT_LE((X_BL * p_L_m).z(), middle_m + 1e-9);
  }
  EXPECT_THROW((void)TriangulateStripe(scan.stripe, scan.plan, scan.rig, {}, {2.0, 1.0}),
               ContractViolation);
}

TEST(RangeProfileTest, BrokenContractsThrow) {
  Scan scan = FloorScan(Laser::kHorizontal);
  const LookUpTable table = Calibrate(scan.rig, Laser::kHorizontal);
  LookUpTable other = table;
  other.laser = Laser::kVertical;
  EXPECT_THROW((void)MeasureProfile(scan.stripe, scan.plan, other, scan.rig), ContractViolation);
  scan.stripe.stripe_index = 2;
  EXPECT_THROW((void)MeasureProfile(scan.stripe, scan.plan, table, scan.rig), ContractViolation);
}

}  // namespace
}  // namespace geon::rangefinder
