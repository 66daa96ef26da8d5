#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "messaging/rate_limiter.h"
#include "mission/mission.h"
#include "procs/planner/planner_config.h"

namespace geon::planner {

// Runs one mission: tells it what robot and recognizer say, steps it 20 times a second, and sends
// what it wishes. BASE_COMMAND goes out with every step and names the newest BASE_STATE;
// PLANNER_STATE at 5 Hz and with every change of phase. After the end the final state is kept on
// the bus; a restarted planner starts a new mission from the search.
class PlannerNode {
 public:
  // `done` is called once, some PLANNER_STATEs after the mission ended.
  PlannerNode(const PlannerConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
              messaging::HealthReporter* health, std::function<void()> done);

  sensor::MissionOutcome outcome() const { return mission_.outcome(); }

 private:
  void Subscribe();
  void TakeHeadImage(const sensor::Image& image);
  void TakeFloorImage(const sensor::Image& image);
  void Step();
  void Send(const mission::Wishes& wishes);
  void SendBaseCommand();
  void SendState();
  void SendView(const mission::Decision& decision);
  void Report();

  PlannerConfig config_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  std::function<void()> done_;
  mission::Mission mission_;
  navigation::DriveVelocity velocity_;
  mission::Phase told_phase_ = mission::Phase::kWait;
  bool base_heard_ = false;
  int states_after_end_ = 0;
  int64_t command_id_;
  messaging::RateLimiter bad_pictures_;
  struct Sequences {
    int32_t base_command = 0, ptu_command = 0, scan_plan = 0, target_mask = 0, scan_command = 0;
    int32_t state = 0, view = 0;
  } seq_;
};

}  // namespace geon::planner
