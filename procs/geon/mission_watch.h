#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/status.h"
#include "messaging/bus.h"
#include "sensor/geon_verdict.h"
#include "sensor/planner_state.h"

namespace geon::cli {

// Follows the mission on the bus until the planner says that it is over.
class MissionWatch {
 public:
  using Progress = std::function<void(const sensor::PlannerState&)>;

  // `progress` is called whenever phase or text change.
  static Result<std::unique_ptr<MissionWatch>> Open(const std::string& lcm_url, Progress progress);

  // Whether the mission ended within this time.
  bool Await(double timeout_s);

  const std::optional<sensor::PlannerState>& state() const { return state_; }
  // The newest verdict.
  const std::optional<sensor::GeonVerdict>& verdict() const { return verdict_; }

 private:
  MissionWatch(std::unique_ptr<messaging::Bus> bus, Progress progress);
  bool Ended() const;

  std::unique_ptr<messaging::Bus> bus_;
  Progress progress_;
  std::optional<sensor::PlannerState> state_;
  std::optional<sensor::GeonVerdict> verdict_;
};

}  // namespace geon::cli
