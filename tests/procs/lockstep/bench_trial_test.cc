#include "procs/lockstep/bench_trial.h"

#include <gtest/gtest.h>

#include "config/daemon_arguments.h"

namespace geon::lockstep {
namespace {

class BenchTrialTest : public testing::Test {
 protected:
  Result<BenchOutcome> RunTrial(const BenchTrial& trial, double dropped_1 = 0.0) const {
    LockstepSettings settings = *settings_;
    settings.sim.renderer.color.dropped_1 = settings.sim.renderer.stripe.dropped_1 = dropped_1;
    return RunBenchTrial(settings, std::nullopt, trial);
  }
  BenchTrial Cylinder(double range_m) const {
    BenchTrial trial;
    trial.shape = geons::GeonShape{GeonLabel::kCylinder, {0.12, 0.12, 0.18}};
    trial.range_m = range_m;
    trial.seed = 5;
    return trial;
  }
  const Result<LockstepSettings> settings_ =
      LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                           config::InstalledFile("scripts/config/sim.yaml"));
};

TEST_F(BenchTrialTest, ACylinderIsScannedAtTheRangeAskedFor) {
  const auto outcome = RunTrial(Cylinder(1.3));
  ASSERT_TRUE(outcome.ok()) << outcome.message();
  ASSERT_TRUE(outcome->verdict.has_value()) << outcome->end;
  EXPECT_EQ(outcome->verdict->label, GeonLabel::kCylinder);
  ASSERT_TRUE(outcome->seen_s && outcome->whole_s);
  EXPECT_LE(*outcome->seen_s, *outcome->whole_s);
  EXPECT_LT(*outcome->whole_s, outcome->end_s);
  // The middle of the front is 6 cm nearer than that of the cylinder.
  const sensor::ScanSet& scan = outcome->scan;
  ASSERT_EQ(scan.profiles.size(), 6U);
  const auto& middle = scan.profiles[1].p_L_m;
  double nearest_m = 1e9;
  for (const Eigen::Vector3d& p_m : middle) {
    nearest_m = std::min(nearest_m, (p_m - scan.camera_position_L_m).norm());
  }
  EXPECT_NEAR(nearest_m, 1.3 - 0.06, 0.03);
  EXPECT_EQ(outcome->mask.size(), 640U * 480U);
}

// With the calibrated rig, within 3 % of the target's extent of their quarter.
TEST_F(BenchTrialTest, StripesLieAtTheirQuartersNearAndFar) {
  for (const double range_m : {0.7, 1.0, 1.5, 2.0}) {
    SCOPED_TRACE(range_m);
    const auto outcome = RunTrial(Cylinder(range_m));
    ASSERT_TRUE(outcome.ok()) << outcome.message();
    ASSERT_EQ(outcome->misplaced_1.size(), 6U) << outcome->end;
    for (const double misplaced_1 : outcome->misplaced_1) EXPECT_LT(std::abs(misplaced_1), 0.03);
  }
}

TEST_F(BenchTrialTest, OneFrameInFiveThatIsLostCostsTimeOnly) {
  const auto whole = RunTrial(Cylinder(1.3)), leaky = RunTrial(Cylinder(1.3), 0.2);
  ASSERT_TRUE(whole.ok() && leaky.ok()) << leaky.message();
  ASSERT_TRUE(leaky->verdict.has_value()) << leaky->end;
  EXPECT_EQ(leaky->verdict->label, GeonLabel::kCylinder);
  EXPECT_EQ(leaky->scan.profiles.size(), 6U);
  EXPECT_GT(leaky->end_s, whole->end_s);
}

TEST_F(BenchTrialTest, AMeshThatIsNotThereIsAnError) {
  BenchTrial trial;
  trial.shape = sim::MeshShape{"/no/such/mesh.obj", 0.2, GeonLabel::kCuboid};
  const auto outcome = RunTrial(trial);
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.message().find("/no/such/mesh.obj"), std::string::npos) << outcome.message();
}

}  // namespace
}  // namespace geon::lockstep
