#include "procs/ptu/ptu_node.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "messaging/channels.h"
#include "messaging/clock.h"
#include "tests/common/device/plug.h"
#include "tests/common/device/scripted_ptu.h"

namespace geon::ptu {
namespace {

using sensor::DeviceStatus;

TEST(PtuStateTest, AnglesAreTaintedUnlessReady) {
  device::PtuReport report;
  report.status = DeviceStatus::kStarting;
  report.samples = 3;
  report.pan_rad = 1.0;
  report.sample_time_s = 9.0;
  report.command_id = 5;
  EXPECT_EQ(StateFromReport(report, 10.0, 2'000'000).pan_rad, 0.0);
  EXPECT_EQ(StateFromReport(report, 10.0, 2'000'000).utime, 2'000'000);
  report.status = DeviceStatus::kReady;
  const sensor::PtuState state = StateFromReport(report, 10.0, 2'000'000);
  EXPECT_EQ(state.pan_rad, 1.0);
  EXPECT_EQ(state.utime, 1'000'000) << "stamped when it was measured";
  EXPECT_EQ(state.command_id, 5);
}

// Node, bus and a pty with a scripted unit behind it, in one loop.
TEST(PtuNodeTest, CarriesCommandsToTheUnitAndItsPositionsToTheBus) {
  const std::string url = "udpm://239.255.76.67:7791?ttl=0";
  device::Plug plug;
  plug.In();
  device::ScriptedPtu unit;
  messaging::PollLoop loop;
  auto node_bus = messaging::Bus::Open({url, "node"});
  auto planner_bus = messaging::Bus::Open({url, "planner"});
  ASSERT_TRUE(node_bus.ok()) << node_bus.message();
  ASSERT_TRUE(planner_bus.ok());
  messaging::HealthReporter health(node_bus->get(), &loop, {"geon-ptu", "test", "test"});
  PtuConfig config;
  config.link = {.path = plug.path(), .baud = 9600};
  const PtuNode node(config, node_bus->get(), &loop, &health);

  sensor::PtuCommand command{.command_id = 77, .pan_rad = 0.5, .tilt_rad = -0.25};
  std::vector<sensor::PtuState> states;
  (*planner_bus)->Subscribe<sensor::PtuState>(messaging::kPtuState, [&](const auto& state) {
    states.push_back(state);
    if (state.command_id == 77 && !state.moving) loop.Stop();
  });
  loop.Watch((*planner_bus)->file_descriptor(), [&] { (*planner_bus)->HandlePending(); });
  loop.Every(0.005, [&] {
    const std::string said = unit.Step(messaging::MonotonicSeconds(), plug.Hear());
    if (!said.empty()) plug.Say(said);
  });
  loop.Every(0.1, [&] {
    ++command.seq;
    (*planner_bus)->Publish(messaging::kPtuCommand, command);
    sensor::PtuCommand nonsense = command;
    nonsense.command_id = 78;
    nonsense.pan_rad = std::numeric_limits<double>::quiet_NaN();
    (*planner_bus)->Publish(messaging::kPtuCommand, nonsense);
    (*planner_bus)->Publish(messaging::kPtuCommand, command);
  });
  const double give_up_s = messaging::MonotonicSeconds() + 30.0;
  loop.Every(0.1, [&] {
    if (messaging::MonotonicSeconds() > give_up_s) loop.Stop();
  });
  loop.Run();

  ASSERT_GE(states.size(), 2u);
  EXPECT_NE(states.front().status, DeviceStatus::kReady) << "said while starting, too";
  const sensor::PtuState& last = states.back();
  EXPECT_EQ(last.status, DeviceStatus::kReady);
  EXPECT_NEAR(last.pan_rad, 0.5, 0.001);
  EXPECT_NEAR(last.tilt_rad, -0.25, 0.001);
  for (size_t i = 1; i < states.size(); ++i) EXPECT_EQ(states[i].seq, states[i - 1].seq + 1);
}

}  // namespace
}  // namespace geon::ptu
