#include "procs/geon/health_watch.h"

#include <poll.h>

#include <chrono>
#include <cmath>

#include "messaging/channels.h"

namespace geon::cli {

namespace {

double SteadyTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Result<std::unique_ptr<HealthWatch>> HealthWatch::Open(const std::string& lcm_url) {
  messaging::BusOptions options;
  options.url = lcm_url;
  options.process = "geon";
  Result<std::unique_ptr<messaging::Bus>> bus = messaging::Bus::Open(options);
  if (!bus.ok()) return bus.status();
  return std::unique_ptr<HealthWatch>(new HealthWatch(*std::move(bus)));
}

HealthWatch::HealthWatch(std::unique_ptr<messaging::Bus> bus) : bus_(std::move(bus)) {
  bus_->Subscribe<sensor::Health>(messaging::kAnyHealth, [this](const sensor::Health& health) {
    heard_[health.process] = {health, SteadyTime()};
  });
}

void HealthWatch::Listen(double duration_s) {
  const double end_s = SteadyTime() + duration_s;
  for (double left_s = duration_s; left_s > 0.0; left_s = end_s - SteadyTime()) {
    pollfd waiting{bus_->file_descriptor(), POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(std::ceil(left_s * 1000.0))) > 0) bus_->HandlePending();
  }
}

const HealthWatch::Heard* HealthWatch::Of(const std::string& process) const {
  const auto found = heard_.find(process);
  return found == heard_.end() ? nullptr : &found->second;
}

double HealthWatch::AgeInSeconds(const Heard& heard) { return SteadyTime() - heard.heard_s; }

std::string ToString(sensor::HealthLevel level) {
  switch (level) {
    case sensor::HealthLevel::kStarting:
      return "starting";
    case sensor::HealthLevel::kOk:
      return "ok";
    case sensor::HealthLevel::kWarn:
      return "warn";
    case sensor::HealthLevel::kFault:
      return "fault";
  }
  return "unknown";
}

}  // namespace geon::cli
