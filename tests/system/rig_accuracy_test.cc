// What `geon calibrate rig` finds of the simulated individual, against how that is really built.
// The calibration sees pictures and encoders only; the truth is asked for here.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "base/angles.h"
#include "calibration/calibrate_rig.h"
#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "procs/geon/board_frames.h"
#include "procs/geon/simulated_rig_frames.h"
#include "rangefinder/stripe_peaks.h"
#include "sim/rig_renderer.h"
#include "sim/sim_config.h"

namespace geon {
namespace {

using geometry::RigidTransform;
using geometry::SensorRig;
using sensor::Laser;

// One calibration with the command's defaults, for all tests.
class RigAccuracy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto robot =
        config::LoadRobotFile(config::InstalledFile("scripts/config/robot.yaml"), {"rig"});
    ASSERT_TRUE(robot.ok()) << robot.message();
    drawn_ = new SensorRig(config::ReadDrawnRig(robot->root().Child("rig")));
    const auto options = sim::LoadSimOptions(config::InstalledFile("scripts/config/sim.yaml"));
    ASSERT_TRUE(options.ok()) << options.message();
    options_ = new sim::SimOptions(*options);
    calibration::RigObservations observations;
    const cli::RigSeries series = cli::SimulatedRig(*drawn_, *options_, observations.board, {}, 1);
    for (int k = 0; k < series.shots; ++k) {
      const auto shot = series.at(k);
      ASSERT_TRUE(shot.ok()) << shot.message();
      const Status status = cli::ObserveShot(*shot, *drawn_, &observations);
      ASSERT_TRUE(status.ok()) << status.message();
    }
    const auto found = calibration::CalibrateRig(observations, *drawn_);
    ASSERT_TRUE(found.ok()) << found.message();
    found_ = new calibration::RigCalibration(*found);
  }
  void SetUp() override { ASSERT_NE(found_, nullptr); }

  static SensorRig* drawn_;
  static sim::SimOptions* options_;
  static calibration::RigCalibration* found_;
};
SensorRig* RigAccuracy::drawn_ = nullptr;
sim::SimOptions* RigAccuracy::options_ = nullptr;
calibration::RigCalibration* RigAccuracy::found_ = nullptr;

// Along the B/W camera's axis, where a pixel's ray meets the fan.
double Depth(const SensorRig& rig, const Eigen::Vector2d& pixel_px, Laser which) {
  const geometry::LaserMount& laser =
      which == Laser::kVertical ? rig.vertical_laser : rig.horizontal_laser;
  const Eigen::Vector3d ray_T =
      rig.X_TB.linear() * rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y());
  return laser.normal_T.dot(laser.p_TLaser_m - rig.X_TB.translation()) / laser.normal_T.dot(ray_T);
}

std::vector<Eigen::Vector2d> PointsOf(const std::vector<sensor::Image>& light, Laser laser) {
  std::vector<Eigen::Vector2d> points_px;
  for (const auto& peak : rangefinder::FindStripePeaks(rangefinder::AverageImages(light), laser)) {
    if (peak.reason != rangefinder::PeakReason::kFound) continue;
    const Eigen::Vector2d along(peak.pixel, peak.position_px);
    points_px.push_back(laser == Laser::kVertical ? along.reverse().eval() : along);
  }
  return points_px;
}

TEST_F(RigAccuracy, RangeIsRightWithoutALookUpTable) {
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const cli::BoardSeries boards =
        cli::SimulatedBoard(*drawn_, options_->renderer, 7, laser, {0.7, 2.0, 0.1, 4});
    for (int k = 0; k < boards.distances; ++k) {
      const auto board = boards.at(k);
      ASSERT_TRUE(board.ok());
      double sum_m = 0.0;
      const std::vector<Eigen::Vector2d> points_px = PointsOf(board->light, laser);
      ASSERT_GT(points_px.size(), 100U) << board->distance_m;
      for (const Eigen::Vector2d& pixel_px : points_px) {
        sum_m += Depth(found_->rig, pixel_px, laser) - board->distance_m;
      }
      const double error_mm = 1000.0 * sum_m / static_cast<double>(points_px.size());
      std::printf("%s %.2f m: %+.3f mm\n", laser == Laser::kVertical ? "vertical" : "horizontal",
                  board->distance_m, error_mm);
      const bool at_1m = std::abs(board->distance_m - 1.0) < 0.01;
      EXPECT_LE(std::abs(error_mm), at_1m ? 0.5 : 1.5) << board->distance_m;
    }
  }
}

// In the frame that the pan-tilt unit itself defines: z along the pan axis, y along the tilt axis
// as near as can be, at the encoders' zeros.
TEST_F(RigAccuracy, LaserPlanesLieWithinAFewHundredthsOfADegree) {
  const sim::RigRenderer renderer(sim::BoardScene(RigidTransform::Identity(), 1.0), *drawn_,
                                  options_->renderer, 1);
  const sim::BuiltRig& built = renderer.built_rig();
  const Eigen::Matrix3d R_RP = built.X_RP.linear();
  const Eigen::Vector3d pan_R = R_RP * built.pan_P.direction;
  const Eigen::Vector3d tilt_R =
      R_RP * built.pan_P.Turn(built.pan_zero_rad).linear() * built.tilt_P.direction;
  Eigen::Matrix3d unit_R;
  unit_R.col(2) = pan_R;
  unit_R.col(0) = tilt_R.cross(pan_R).normalized();
  unit_R.col(1) = pan_R.cross(unit_R.col(0));
  for (const auto& [name, laser, found] :
       {std::tuple("horizontal", &built.horizontal_laser, &found_->rig.horizontal_laser),
        std::tuple("vertical", &built.vertical_laser, &found_->rig.vertical_laser)}) {
    const Eigen::Vector3d normal =
        unit_R.transpose() * built.HeadPose(0.0, 0.0).linear() * laser->normal_T;
    const double angle_deg =
        DegreesFromRadians(std::acos(std::min(1.0, std::abs(normal.dot(found->normal_T)))));
    std::printf("%s laser plane: %.4f degrees off\n", name, angle_deg);
    EXPECT_LE(angle_deg, 0.05);
  }
}

// A straight piece of a stripe in the picture of the first head pose, and the depth along it.
struct Piece {
  Eigen::Vector2d line = Eigen::Vector2d::Zero();   // across = line[0] + line[1] * along
  Eigen::Vector2d depth = Eigen::Vector2d::Zero();  // depth = depth[0] + depth[1] * along
};
Piece FitNear(const std::vector<Eigen::Vector3d>& stripe,
              double middle) {  // (along, across, depth)
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : stripe) {
    if (std::abs(point[0] - middle) > 40.0) continue;
    const Eigen::Vector2d row(1.0, point[0]);
    normal += row * row.transpose();
    right += row * point.tail<2>().transpose();
  }
  const Eigen::Matrix2d solution = normal.inverse() * right;
  return {solution.col(0), solution.col(1)};
}

TEST_F(RigAccuracy, BothLasersAgreeWhereTheirStripesCross) {
  sim::RigRenderer renderer(sim::BoardScene(RigidTransform::Identity(), 1.0), *drawn_,
                            options_->renderer, 5);
  renderer.SetScene(sim::BoardScene(renderer.StripeCameraPose({}), 1.0));
  const SensorRig& rig = found_->rig;
  const RigidTransform X_RB = rig.StripeCameraPose(0.0, 0.0);
  int64_t seq = 0;
  // Points of one stripe in the first picture: (along, across, depth).
  const auto stripe = [&](Laser laser, double turn_deg) {
    sim::RigPose pose;
    (laser == Laser::kVertical ? pose.pan_rad : pose.tilt_rad) = RadiansFromDegrees(turn_deg);
    sim::LaserFractions burning;
    (laser == Laser::kVertical ? burning.vertical_1 : burning.horizontal_1) = 1.0;
    std::vector<sensor::Image> light;
    for (int k = 0; k < 10; ++k) {
      const auto gray = [](sim::Frame frame) {
        sensor::Image image;
        image.width_px = image.row_stride_bytes = frame.width_px;
        image.height_px = frame.height_px;
        image.data = std::move(frame.pixels);
        return image;
      };
      const auto lit = gray(renderer.HeadBw(pose, burning, ++seq));
      const auto dark = gray(renderer.HeadBw(pose, {}, ++seq));
      light.push_back(rangefinder::LaserLight(lit, dark, rangefinder::LaserColor::kMono));
    }
    const RigidTransform X_RBnow = rig.StripeCameraPose(pose.pan_rad, pose.tilt_rad);
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& pixel_px : PointsOf(light, laser)) {
      const Eigen::Vector3d p_B =
          X_RB.inverse() * X_RBnow *
          (Depth(rig, pixel_px, laser) * rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y()));
      const Eigen::Vector2d seen_px = rig.stripe_camera.Project(p_B);
      const bool vertical = laser == Laser::kVertical;
      points.emplace_back(vertical ? seen_px.y() : seen_px.x(),
                          vertical ? seen_px.x() : seen_px.y(), p_B.z());
    }
    return points;
  };
  for (const double tilt_deg : {-2.0, 0.0, 2.0}) {
    const auto horizontal = stripe(Laser::kHorizontal, tilt_deg);
    for (const double pan_deg : {-2.5, 0.0, 2.5}) {
      const auto vertical = stripe(Laser::kVertical, pan_deg);
      double u_px = 320.0;
      double v_px = 240.0;
      Piece h;
      Piece v;
      for (int round = 0; round < 4; ++round) {
        h = FitNear(horizontal, u_px);
        v_px = h.line[0] + h.line[1] * u_px;
        v = FitNear(vertical, v_px);
        u_px = v.line[0] + v.line[1] * v_px;
      }
      const double apart_mm =
          1000.0 * (h.depth[0] + h.depth[1] * u_px - v.depth[0] - v.depth[1] * v_px);
      std::printf("crossing at (%.0f, %.0f): %+.3f mm apart\n", u_px, v_px, apart_mm);
      EXPECT_LE(std::abs(apart_mm), 0.3);
    }
  }
}

TEST_F(RigAccuracy, TheFloorIsWhereItIs) {
  const sim::RigRenderer renderer(sim::BoardScene(RigidTransform::Identity(), 1.0), *drawn_,
                                  options_->renderer, 1);
  const sim::BuiltRig& built = renderer.built_rig();
  ASSERT_TRUE(found_->floor.has_value());
  // The camera's height over the floor and how far its axis looks down, over the head's range.
  for (const double tilt_deg : {-40.0, -20.0, 0.0}) {
    for (const double pan_deg : {-30.0, 0.0, 30.0}) {
      const double pan_rad = RadiansFromDegrees(pan_deg);
      const double tilt_rad = RadiansFromDegrees(tilt_deg);
      const RigidTransform found = found_->rig.StripeCameraPose(pan_rad, tilt_rad);
      const RigidTransform truth = built.StripeCameraPose(pan_rad, tilt_rad);
      EXPECT_NEAR(found.translation().z(), truth.translation().z(), 0.002) << pan_deg;
      EXPECT_NEAR(std::asin(found.linear()(2, 2)), std::asin(truth.linear()(2, 2)), 0.004);
    }
  }
}

}  // namespace
}  // namespace geon
