#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "base/angles.h"
#include "device/nomad_driver.h"
#include "sim/nomad_emulator.h"
#include "tests/device_pairing/paired_line.h"

namespace geon {
namespace {

using sensor::DeviceStatus;

// A room with four smooth walls at x, y = +-reach.
class SquareRoom : public sim::Surroundings {
 public:
  explicit SquareRoom(double reach_m) : reach_m_(reach_m) {}
  std::optional<sim::RayHit> CastRay(const Eigen::Vector3d& origin,
                                     const Eigen::Vector3d& direction, double) const override {
    std::optional<sim::RayHit> nearest;
    for (const int axis : {0, 1}) {
      if (std::abs(direction[axis]) < 1e-9) continue;
      const double side = direction[axis] > 0 ? 1.0 : -1.0;
      const double distance_m = (side * reach_m_ - origin[axis]) / direction[axis];
      if (nearest && distance_m >= nearest->distance_m) continue;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      normal[axis] = -side;
      nearest = sim::RayHit{distance_m, normal, 0.5};
    }
    return nearest;
  }
  std::vector<sim::DiscContact> ContactsOfDisc(const Eigen::Vector2d& center,
                                               double radius_m) const override {
    std::vector<sim::DiscContact> contacts;
    const double clearances_m[] = {reach_m_ - center.x(), reach_m_ - center.y(),
                                   reach_m_ + center.x(), reach_m_ + center.y()};
    for (int i = 0; i < 4; ++i) {
      const double clearance_m = clearances_m[i] - radius_m;
      if (clearance_m <= kContactReach_m) {
        contacts.push_back({WrapAngle(0.5 * kPi * i), clearance_m});
      }
    }
    return contacts;
  }

 private:
  double reach_m_;
};

class NomadPairingTest : public testing::Test {
 protected:
  bool Ready() const { return driver_.report().status == DeviceStatus::kReady; }
  bool BecomesReady(double limit_s = 3.0) {
    return line_.RunUntil([this] { return Ready(); }, limit_s);
  }
  const device::NomadSample& Sample() const { return driver_.report().sample; }

  SquareRoom room_{3.0};
  sim::NomadEmulator robot_{{}, &room_};
  device::NomadDriver driver_;
  PairedLine<device::NomadDriver> line_{&driver_, &robot_};
};

TEST_F(NomadPairingTest, IsReadyWithinASecondAndPolledTwentyTimesASecond) {
  ASSERT_TRUE(BecomesReady(1.0)) << driver_.report().text;
  const int before = driver_.report().samples;
  line_.Run(5.0);
  EXPECT_NEAR(driver_.report().samples - before, 100, 10);
  EXPECT_EQ(driver_.report().recoveries, 0);
}

TEST_F(NomadPairingTest, DrivesAndTurnsAsToldAndKnowsWhereItIs) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.2, 0.0);
  line_.Run(5.0);
  EXPECT_NEAR(Sample().speed_m_s, 0.2, 0.01);
  EXPECT_NEAR(robot_.drive().true_speed_m_s(), 0.2, 0.01);
  EXPECT_TRUE(Sample().moving);
  driver_.Drive(0.0, 0.5);
  line_.Run(3.0);
  driver_.Halt();
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().halted; }, 2.0));
  EXPECT_NEAR(Sample().x_m, robot_.drive().center_W_m().x(), 0.01);
  EXPECT_NEAR(Sample().y_m, robot_.drive().center_W_m().y(), 0.01);
  EXPECT_NEAR(WrapAngle(Sample().steer_rad - robot_.drive().heading_W_rad()), 0.0, 0.005);
  EXPECT_NEAR(WrapAngle(Sample().turret_rad - robot_.drive().turret_W_rad()), 0.0, 0.005);
  EXPECT_NEAR(WrapAngle(Sample().steer_rad - Sample().turret_rad), 0.0, 0.02);
  EXPECT_GT(Sample().steer_rad, 1.0) << "positive turns left";
}

TEST_F(NomadPairingTest, StopsFromFullSpeedWithinHalfASecondAndAQuarterMetre) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.5, 0.0);
  line_.Run(2.0);
  ASSERT_NEAR(robot_.drive().true_speed_m_s(), 0.5, 0.01);
  const double from_m = robot_.drive().center_W_m().x();
  const double from_s = line_.time_s();
  driver_.Halt();
  ASSERT_TRUE(line_.RunUntil([this] { return robot_.drive().true_speed_m_s() == 0.0; }, 2.0));
  EXPECT_LE(line_.time_s() - from_s, 0.5);
  EXPECT_LE(robot_.drive().center_W_m().x() - from_m, 0.25);
}

TEST_F(NomadPairingTest, TheDeadManStopsARobotWhoseHostHasDied) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.3, 0.0);
  line_.Run(1.0);
  line_.Close();
  line_.Run(0.8);
  EXPECT_GT(robot_.drive().true_speed_m_s(), 0.2) << "one second has not passed";
  line_.Run(0.8);
  EXPECT_EQ(robot_.drive().true_speed_m_s(), 0.0);
  line_.Open();
  ASSERT_TRUE(BecomesReady());
  line_.Run(0.5);
  EXPECT_EQ(robot_.drive().true_speed_m_s(), 0.0);
}

TEST_F(NomadPairingTest, SonarsSeeTheWallsAllRound) {
  ASSERT_TRUE(BecomesReady());
  line_.Run(3.0);
  // Squarely ahead, left, behind and right, from the ring's rim.
  for (const size_t i : {0u, 4u, 8u, 12u}) {
    EXPECT_NEAR(Sample().sonar_m[i], 3.0 - 0.225, 0.12) << i;
  }
}

TEST_F(NomadPairingTest, SonarRangesFollowTheTurret) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.3, 0.0);
  ASSERT_TRUE(line_.RunUntil([this] { return Sample().x_m > 1.0; }, 10.0));
  driver_.Drive(0.0, 0.5);
  ASSERT_TRUE(line_.RunUntil([this] { return Sample().steer_rad > 0.5 * kPi - 0.08; }, 10.0));
  driver_.Halt();
  line_.Run(3.0);
  const double x_m = Sample().x_m;
  EXPECT_NEAR(Sample().sonar_m[0], 3.0 - 0.225, 0.15) << "now looks along y";
  EXPECT_NEAR(Sample().sonar_m[12], 3.0 - x_m - 0.225, 0.15) << "the right one along x";
  EXPECT_NEAR(Sample().sonar_m[4], 3.0 + x_m - 0.225, 0.15);
}

TEST_F(NomadPairingTest, ABumperAheadIsPressedAtTheWall) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.4, 0.0);
  ASSERT_TRUE(line_.RunUntil(
      [this] {
        return std::any_of(Sample().bumper.begin(), Sample().bumper.end(),
                           [](bool pressed) { return pressed; });
      },
      20.0));
  EXPECT_TRUE(Sample().bumper[0]);
  EXPECT_FALSE(Sample().bumper[10]);
  EXPECT_NEAR(robot_.drive().center_W_m().x(), 3.0 - 0.267, 0.05);
  driver_.Drive(-0.2, 0.0);
  EXPECT_TRUE(line_.RunUntil([this] { return !Sample().bumper[0]; }, 3.0));
}

TEST_F(NomadPairingTest, InfraredRisesTowardsAWall) {
  ASSERT_TRUE(BecomesReady());
  line_.Run(0.5);
  const int far = Sample().infrared[0];
  driver_.Drive(0.3, 0.0);
  ASSERT_TRUE(line_.RunUntil([this] { return Sample().x_m > 2.55; }, 20.0));
  driver_.Halt();
  line_.Run(1.0);
  EXPECT_GT(Sample().infrared[0], far);
  EXPECT_EQ(Sample().infrared[8], far);
}

TEST_F(NomadPairingTest, ARobotThatRestartsInMidDriveIsSetUpAgainAndStaysStopped) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.3, 0.0);
  line_.Run(3.0);
  const double x_m = Sample().x_m;
  robot_.PowerCycle(line_.time_s());
  ASSERT_TRUE(line_.RunUntil([this] { return !Ready(); }, 1.0));
  ASSERT_TRUE(BecomesReady()) << driver_.report().text;
  EXPECT_EQ(driver_.report().restarts, 1);
  line_.Run(1.0);
  EXPECT_EQ(robot_.drive().true_speed_m_s(), 0.0);
  EXPECT_NEAR(Sample().x_m, x_m, 0.1) << "the odometry goes on";
  // The dead-man was set anew.
  driver_.Drive(0.3, 0.0);
  line_.Run(1.0);
  line_.Close();
  line_.Run(2.0);
  EXPECT_EQ(robot_.drive().true_speed_m_s(), 0.0);
}

TEST_F(NomadPairingTest, TenThousandGarbageStringsBothWaysLeaveBothAliveAndInStep) {
  std::mt19937 random(12);
  ASSERT_TRUE(BecomesReady());
  for (int i = 0; i < 10'000; ++i) {
    line_.Garble(&random, 12);
    line_.Run(0.02);
  }
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().halted; }, 10.0))
      << driver_.report().text;
  driver_.Drive(0.2, 0.0);
  line_.Run(1.0);
  EXPECT_TRUE(Ready());
  EXPECT_NEAR(robot_.drive().true_speed_m_s(), 0.2, 0.01);
}

}  // namespace
}  // namespace geon
