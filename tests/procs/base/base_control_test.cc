#include "procs/base/base_control.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "tests/common/device/scripted_nomad.h"

namespace geon::base {
namespace {

TEST(BumperBearingsTest, TheBaseDoesNotTurnWithTheSteering) {
  const auto bearings = BumperBearings(RadiansFromDegrees(9.0), RadiansFromDegrees(90.0));
  EXPECT_NEAR(bearings[0], RadiansFromDegrees(-81.0), 1e-12);
  EXPECT_NEAR(bearings[5], RadiansFromDegrees(9.0), 1e-12);
  EXPECT_NEAR(bearings[15], RadiansFromDegrees(-171.0), 1e-9);
}

// A robot at the other end of the line, in virtual time; answers each state with a wish to drive.
class DrivenBase {
 public:
  DrivenBase() { control_.Connected(0.0); }

  void RunUntil(double until_s) {
    for (; time_s_ < until_s; time_s_ += 0.005) {
      const int64_t utime = 1'000'000 + static_cast<int64_t>(time_s_ * 1e6);
      const std::string heard = robot_.Step(time_s_, said_);
      said_ = control_.Step(time_s_, utime, heard);
      for (const BaseNews& news : control_.TakeNews()) {
        newest = news;
        ++told;
        if (news.state.status == sensor::DeviceStatus::kReady) Answer(news.state);
      }
    }
  }

  double wanted_m_s = 0.3;
  bool planner_alive = true;
  BaseNews newest;
  int told = 0;

 private:
  void Answer(const sensor::BaseState& state) {
    if (!planner_alive) return;
    sensor::BaseCommand command;
    command.utime = state.utime;
    command.seq = ++seq_;
    command.command_id = seq_;
    command.state_seq = state.seq;
    command.speed_m_s = wanted_m_s;
    control_.Take(time_s_, command);
  }

  BaseControl control_{BaseConfig{}};
  device::ScriptedNomad robot_;
  std::string said_;
  double time_s_ = 0.0;
  int seq_ = 0;
};

TEST(BaseControlTest, TellsAStateAndSensorsForEachReadingStampedWhenItWasTaken) {
  DrivenBase base;
  base.RunUntil(2.0);
  ASSERT_EQ(base.newest.state.status, sensor::DeviceStatus::kReady);
  EXPECT_TRUE(base.newest.measured);
  EXPECT_EQ(base.newest.sonar.utime, base.newest.state.utime);
  EXPECT_EQ(base.newest.bumper.utime, base.newest.state.utime);
  EXPECT_LE(base.newest.state.utime, 3'000'000);
  EXPECT_GT(base.newest.state.utime, 2'800'000);
  const int told = base.told;
  base.RunUntil(3.0);
  EXPECT_NEAR(base.told - told, 20, 2);
}

TEST(BaseControlTest, DrivesWhileCommandsAreFreshAndStandsWhenThePlannerIsGone) {
  DrivenBase base;
  base.RunUntil(3.0);
  EXPECT_EQ(base.newest.state.stop, sensor::BaseStop::kNone);
  base.planner_alive = false;
  base.RunUntil(4.0);
  EXPECT_EQ(base.newest.state.stop, sensor::BaseStop::kCommandExpired);
}

}  // namespace
}  // namespace geon::base
