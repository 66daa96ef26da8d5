#include "procs/geon/mission_watch.h"

#include <poll.h>

#include <chrono>

#include "messaging/channels.h"

namespace geon::cli {

Result<std::unique_ptr<MissionWatch>> MissionWatch::Open(const std::string& lcm_url,
                                                         Progress progress) {
  messaging::BusOptions options;
  options.url = lcm_url;
  options.process = "geon";
  Result<std::unique_ptr<messaging::Bus>> bus = messaging::Bus::Open(options);
  if (!bus.ok()) return bus.status();
  return std::unique_ptr<MissionWatch>(new MissionWatch(*std::move(bus), std::move(progress)));
}

MissionWatch::MissionWatch(std::unique_ptr<messaging::Bus> bus, Progress progress)
    : bus_(std::move(bus)), progress_(std::move(progress)) {
  bus_->Subscribe<sensor::PlannerState>(
      messaging::kPlannerState, [this](const sensor::PlannerState& state) {
        const bool news = !state_ || state_->phase != state.phase || state_->text != state.text;
        state_ = state;
        if (news) progress_(state);
      });
  bus_->Subscribe<sensor::GeonVerdict>(
      messaging::kGeonVerdict, [this](const sensor::GeonVerdict& verdict) { verdict_ = verdict; });
}

// A mission that named its geon has heard the verdict; we may hear it a moment later.
bool MissionWatch::Ended() const {
  if (!state_) return false;
  if (state_->outcome == sensor::MissionOutcome::kNamed) return verdict_.has_value();
  return state_->outcome != sensor::MissionOutcome::kRunning;
}

bool MissionWatch::Await(double timeout_s) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(timeout_s);
  while (!Ended() && Clock::now() < end) {
    pollfd waiting{bus_->file_descriptor(), POLLIN, 0};
    if (poll(&waiting, 1, 200) > 0) bus_->HandlePending();
  }
  return Ended();
}

}  // namespace geon::cli
