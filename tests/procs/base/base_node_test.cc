#include "procs/base/base_node.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "messaging/channels.h"
#include "messaging/clock.h"
#include "tests/common/device/plug.h"
#include "tests/common/device/scripted_nomad.h"

namespace geon::base {
namespace {

using sensor::BaseStop;
using sensor::DeviceStatus;

// Node, bus, a planner that answers every state, and a pty with a scripted robot behind it.
class BaseNodeTest : public testing::Test {
 protected:
  BaseNodeTest() {
    plug_.In();
    config_.link.path = plug_.path();
    const std::string url = "udpm://239.255.76.67:7792?ttl=0";
    node_bus_ = messaging::Bus::Open({url, "node"}).value();
    planner_bus_ = messaging::Bus::Open({url, "planner"}).value();
    health_ = std::make_unique<messaging::HealthReporter>(
        node_bus_.get(), &loop_, messaging::HealthIdentity{"geon-base", "test", "test"});
    node_ = std::make_unique<BaseNode>(config_, node_bus_.get(), &loop_, health_.get());
    planner_bus_->Subscribe<sensor::BaseState>(messaging::kBaseState,
                                               [this](const auto& state) { Answer(state); });
    planner_bus_->Subscribe<sensor::SonarScan>(messaging::kSonar,
                                               [this](const auto& scan) { sonar_ = scan; });
    planner_bus_->Subscribe<sensor::BumperState>(messaging::kBumper,
                                                 [this](const auto& bumper) { bumper_ = bumper; });
    loop_.Watch(planner_bus_->file_descriptor(), [this] { planner_bus_->HandlePending(); });
    loop_.Every(0.005, [this] { StepRobot(); });
  }

  void Answer(const sensor::BaseState& state) {
    state_ = state;
    if (!planner_alive_) return;
    sensor::BaseCommand command;
    command.utime = messaging::Utime();
    command.seq = ++command_seq_;
    command.command_id = command_seq_;
    command.state_seq = state.seq;
    command.speed_m_s = wanted_m_s_;
    planner_bus_->Publish(messaging::kBaseCommand, command);
  }
  void StepRobot() {
    const std::string said = robot_.Step(messaging::MonotonicSeconds(), plug_.Hear());
    if (!said.empty()) plug_.Say(said);
  }
  bool RunUntil(const std::function<bool()>& condition) {
    const double give_up_s = messaging::MonotonicSeconds() + 30.0;
    bool held = false;
    loop_.Every(0.01, [&, give_up_s] {
      if (held) return;
      held = condition();
      if (held || messaging::MonotonicSeconds() > give_up_s) loop_.Stop();
    });
    loop_.Run();
    return held;
  }

  device::Plug plug_;
  device::ScriptedNomad robot_;
  BaseConfig config_;
  messaging::PollLoop loop_;
  std::unique_ptr<messaging::Bus> node_bus_;
  std::unique_ptr<messaging::Bus> planner_bus_;
  std::unique_ptr<messaging::HealthReporter> health_;
  std::unique_ptr<BaseNode> node_;
  sensor::BaseState state_;
  sensor::SonarScan sonar_;
  sensor::BumperState bumper_;
  bool planner_alive_ = true;
  double wanted_m_s_ = 0.3;
  int32_t command_seq_ = 0;
};

TEST_F(BaseNodeTest, DrivesOnFreshCommandsAndStopsTheRobotOnTheWayOut) {
  EXPECT_TRUE(RunUntil([this] { return robot_.velocity[0] == 118 && sonar_.seq > 2; }));
  EXPECT_EQ(state_.status, DeviceStatus::kReady);
  EXPECT_GT(state_.command_id, 0);
  EXPECT_NEAR(sonar_.range_m[4], 2.54, 1e-9);
  StepRobot();  // what was said on the way out
  EXPECT_EQ(robot_.velocity[0], 0);
  EXPECT_NE(std::find(robot_.types.end() - 3, robot_.types.end(), 9), robot_.types.end());
}

TEST_F(BaseNodeTest, ASilentPlannerStopsTheRobot) {
  bool drove = false;
  EXPECT_TRUE(RunUntil([&] {
    drove |= robot_.velocity[0] > 0;
    if (drove) planner_alive_ = false;
    return drove && robot_.velocity[0] == 0 && state_.stop == BaseStop::kCommandExpired;
  }));
}

TEST_F(BaseNodeTest, AHitStopsTheRobotWhateverThePlannerSaysAndBackingOffFreesIt) {
  bool hit = false;
  bool stopped = false;
  EXPECT_TRUE(RunUntil([&] {
    if (!hit && robot_.velocity[0] > 0) {
      robot_.bumpers = 1;  // in front
      hit = true;
    }
    if (hit && !stopped && state_.stop == BaseStop::kBumper && robot_.velocity[0] == 0) {
      stopped = true;
      wanted_m_s_ = -0.1;
    }
    return stopped && robot_.velocity[0] == -39 && bumper_.pressed[0];
  }));
  EXPECT_EQ(bumper_.contact_count, 1);
}

}  // namespace
}  // namespace geon::base
