#include "active_vision/center_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/contracts.h"
#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

using sensor::PixelBox;

// The box round the part of an upright target (a plate of the given size at p_R_m, its foot's
// middle) that the colour camera sees.
std::optional<PixelBox> Look(const geometry::SensorRig& rig, const HeadAngles& head,
                             const Eigen::Vector3d& p_R_m, double width_m, double height_m) {
  const auto X_CR = rig.ColorCameraPose(head.pan_rad, head.tilt_rad).inverse();
  const Eigen::Vector3d across_R(-p_R_m.y(), p_R_m.x(), 0.0);
  double u_min = 1e9, u_max = -1e9, v_min = 1e9, v_max = -1e9;
  for (const double side : {-0.5, 0.5}) {
    for (const double up : {0.0, 1.0}) {
      const Eigen::Vector3d corner_R =
          p_R_m + side * width_m * across_R.normalized() + up * height_m * Eigen::Vector3d::UnitZ();
      const Eigen::Vector2d pixel_px = rig.color_camera.Project(X_CR * corner_R);
      u_min = std::min(u_min, pixel_px.x());
      u_max = std::max(u_max, pixel_px.x());
      v_min = std::min(v_min, pixel_px.y());
      v_max = std::max(v_max, pixel_px.y());
    }
  }
  const int left = std::max(0, static_cast<int>(std::lround(u_min)));
  const int right = std::min(639, static_cast<int>(std::lround(u_max)));
  const int top = std::max(0, static_cast<int>(std::lround(v_min)));
  const int bottom = std::min(479, static_cast<int>(std::lround(v_max)));
  if (left > right || top > bottom) return std::nullopt;
  return PixelBox{left, top, right - left + 1, bottom - top + 1};
}

TEST(CenterTargetTest, AngleFromEdgeAgreesWithThePrintedFormula) {
  // (4.27): d / b times the field of view, first-order only.
  const double view_rad = 2.0 * std::atan(320.0 / 1600.0);
  for (const double d_px : {40.0, 160.0, 320.0, 500.0, 640.0}) {
    const double angle_rad = AngleFromEdge(d_px, 320.0, 1600.0);
    EXPECT_NEAR(angle_rad, d_px / 640.0 * view_rad, 0.003) << d_px;
  }
  EXPECT_NEAR(AngleFromEdge(320.0, 320.0, 1600.0), view_rad / 2.0, 1e-12);
}

TEST(CenterTargetTest, TargetInsideTheImageNeedsNoTurn) {
  const auto step = CenterTarget(TestRig(), {1, 1, 638, 478}, {0.2, -0.3}, {});
  EXPECT_EQ(step.outcome, Centering::kInView);
  EXPECT_EQ(step.head, (HeadAngles{0.2, -0.3}));
}

TEST(CenterTargetTest, TurnsByThreeQuartersOfTheFreeAngle) {
  const geometry::SensorRig level = TestRig(0.0);
  const double free_rad = AngleFromEdge(400, 319.5, 1600.0);
  const auto right = CenterTarget(level, {400, 100, 240, 100}, {}, {});
  EXPECT_EQ(right.outcome, Centering::kTurn);
  EXPECT_NEAR(right.head.pan_rad, -0.75 * free_rad, 1e-9) << "clockwise is negative";
  EXPECT_NEAR(right.head.tilt_rad, 0.0, 1e-9);
  const auto left = CenterTarget(level, {0, 100, 240, 100}, {}, {});
  EXPECT_NEAR(left.head.pan_rad, 0.75 * free_rad, 1e-9);
}

TEST(CenterTargetTest, TopEdgeTiltsUpAndBottomEdgeDown) {
  const geometry::SensorRig level = TestRig(0.0);
  const double free_rad = AngleFromEdge(300, 239.5, 1600.0);
  const auto bottom = CenterTarget(level, {300, 300, 50, 180}, {}, {});
  EXPECT_NEAR(bottom.head.tilt_rad, -0.75 * free_rad, 1e-9);
  EXPECT_NEAR(bottom.head.pan_rad, 0.0, 1e-9);
  const auto top = CenterTarget(level, {300, 0, 50, 180}, {}, {});
  EXPECT_NEAR(top.head.tilt_rad, 0.75 * free_rad, 1e-9);
}

TEST(CenterTargetTest, StepFractionIsUsed) {
  CenteringOptions half;
  half.step_fraction_1 = 0.5;
  const auto step = CenterTarget(TestRig(0.0), {400, 100, 240, 100}, {}, {}, half);
  EXPECT_NEAR(step.head.pan_rad, -0.5 * AngleFromEdge(400, 319.5, 1600.0), 1e-9);
}

TEST(CenterTargetTest, BoxWithinTheEdgeMarginTouches) {
  CenteringOptions margin;
  margin.edge_px = 3;
  EXPECT_EQ(CenterTarget(TestRig(), {3, 100, 50, 50}, {}, {}, margin).outcome, Centering::kTurn);
  EXPECT_EQ(CenterTarget(TestRig(), {4, 100, 50, 50}, {}, {}, margin).outcome, Centering::kInView);
}

TEST(CenterTargetTest, TargetOnOppositeEdgesIsTooLarge) {
  EXPECT_EQ(CenterTarget(TestRig(), {0, 100, 640, 50}, {}, {}).outcome, Centering::kTooLarge);
  EXPECT_EQ(CenterTarget(TestRig(), {100, 0, 50, 480}, {}, {}).outcome, Centering::kTooLarge);
}

TEST(CenterTargetTest, HeadAtItsLimitSaysSo) {
  const HeadLimits limits{-0.1, 0.1, -0.5, 0.2};
  const auto beyond = CenterTarget(TestRig(0.0), {400, 100, 240, 100}, {0.0, 0.0}, limits);
  EXPECT_EQ(beyond.outcome, Centering::kTurn);
  EXPECT_NEAR(beyond.head.pan_rad, -0.1, 1e-12) << "as far as it goes";
  const auto stuck = CenterTarget(TestRig(0.0), {400, 100, 240, 100}, {-0.1, 0.0}, limits);
  EXPECT_EQ(stuck.outcome, Centering::kAtLimit);
}

TEST(CenterTargetTest, AFewStepsBringAPartlySeenTargetIntoView) {
  const geometry::SensorRig rig = TestRig();
  int partly_seen = 0;
  for (const double bearing_rad : {-0.5, -0.2, 0.0, 0.3, 0.6}) {
    const Eigen::Vector3d p_R_m(1.1 * std::cos(bearing_rad), 1.1 * std::sin(bearing_rad), 0.0);
    for (const double pan_off_rad : {-0.18, 0.0, 0.18}) {
      for (const double tilt_off_rad : {-0.12, 0.0, 0.12}) {
        HeadAngles head{bearing_rad + pan_off_rad, RadiansFromDegrees(-28.0) + tilt_off_rad};
        if (!Look(rig, head, p_R_m, 0.2, 0.25)) continue;  // nothing of it to be seen
        ++partly_seen;
        Centering outcome = Centering::kTurn;
        for (int step = 0; step < 6 && outcome == Centering::kTurn; ++step) {
          const auto box = Look(rig, head, p_R_m, 0.2, 0.25);
          ASSERT_TRUE(box) << "lost at " << bearing_rad << " " << pan_off_rad << " "
                           << tilt_off_rad;
          const auto next = CenterTarget(rig, *box, head, {});
          outcome = next.outcome;
          head = next.head;
        }
        EXPECT_EQ(outcome, Centering::kInView)
            << bearing_rad << " " << pan_off_rad << " " << tilt_off_rad;
      }
    }
  }
  EXPECT_GE(partly_seen, 25);
}

TEST(CenterTargetTest, EmptyBoxThrows) {
  EXPECT_THROW(CenterTarget(TestRig(), {10, 10, 0, 5}, {}, {}), ContractViolation);
}

}  // namespace
}  // namespace geon::active_vision
