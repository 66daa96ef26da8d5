#include "procs/planner/planner_node.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "messaging/channels.h"
#include "messaging/clock.h"

namespace geon::planner {
namespace {

// The node of the shipped robot file on a bus of its own, with an ear beside it.
class PlannerNodeTest : public testing::Test {
 protected:
  PlannerNodeTest() {
    config::DaemonArguments arguments("geon-planner", "test", "test");
    config_ = *LoadPlannerConfig(arguments);
    config_.mission.patience.device_s = 0.8;
    const std::string url = "udpm://239.255.76.67:7793?ttl=0";
    node_bus_ = *messaging::Bus::Open({url, "node"});
    robot_bus_ = *messaging::Bus::Open({url, "robot"});
    robot_bus_->Subscribe<sensor::PlannerState>(
        messaging::kPlannerState, [this](const auto& state) { states_.push_back(state); });
    robot_bus_->Subscribe<sensor::BaseCommand>(
        messaging::kBaseCommand, [this](const auto& command) { commands_.push_back(command); });
    loop_.Watch(robot_bus_->file_descriptor(), [this] { robot_bus_->HandlePending(); });
  }

  // Runs the node until it says that it is done, or for 20 s.
  void Run() {
    messaging::HealthReporter health(node_bus_.get(), &loop_, {"geon-planner", "test", "test"});
    const PlannerNode node(config_, node_bus_.get(), &loop_, &health, [this] {
      ++done_;
      loop_.Stop();
    });
    const double give_up_s = messaging::MonotonicSeconds() + 20.0;
    loop_.Every(0.1, [this, give_up_s] {
      if (messaging::MonotonicSeconds() > give_up_s) loop_.Stop();
    });
    loop_.Run();
    outcome_ = node.outcome();
  }

  PlannerConfig config_;
  messaging::PollLoop loop_;
  std::unique_ptr<messaging::Bus> node_bus_, robot_bus_;
  std::vector<sensor::PlannerState> states_;
  std::vector<sensor::BaseCommand> commands_;
  sensor::MissionOutcome outcome_ = sensor::MissionOutcome::kRunning;
  int done_ = 0;
};

TEST_F(PlannerNodeTest, WithoutARobotItWaitsSaysForWhatAndGivesUpWithAReason) {
  Run();
  EXPECT_EQ(done_, 1);
  EXPECT_EQ(outcome_, sensor::MissionOutcome::kFailed);
  EXPECT_TRUE(commands_.empty()) << "no command before the base was heard";
  ASSERT_GE(states_.size(), 3U);
  EXPECT_EQ(states_.front().phase, "wait");
  EXPECT_NE(states_.front().text.find("waiting for the"), std::string::npos)
      << states_.front().text;
  EXPECT_EQ(states_.back().outcome, sensor::MissionOutcome::kFailed);
  EXPECT_FALSE(states_.back().text.empty());
  for (size_t i = 1; i < states_.size(); ++i) EXPECT_EQ(states_[i].seq, states_[i - 1].seq + 1);
}

TEST_F(PlannerNodeTest, CommandsNameTheNewestBaseStateAndDoNotDriveWhileADeviceIsAway) {
  sensor::BaseState state;
  state.status = sensor::DeviceStatus::kReady;
  loop_.Every(0.05, [&] {
    ++state.seq;
    state.utime = messaging::Utime();
    robot_bus_->Publish(messaging::kBaseState, state);
  });
  Run();
  ASSERT_GE(commands_.size(), 5U);
  for (size_t i = 1; i < commands_.size(); ++i) {
    EXPECT_EQ(commands_[i].speed_m_s, 0.0);
    EXPECT_EQ(commands_[i].turn_rate_rad_s, 0.0);
    EXPECT_GE(commands_[i].state_seq, commands_[i - 1].state_seq);
    EXPECT_GT(commands_[i].command_id, commands_[i - 1].command_id);
  }
  EXPECT_GT(commands_.back().state_seq, commands_.front().state_seq);
  EXPECT_EQ(outcome_, sensor::MissionOutcome::kFailed) << "the pan-tilt unit never came";
}

}  // namespace
}  // namespace geon::planner
