#pragma once

#include <map>
#include <memory>
#include <string>

#include "base/status.h"
#include "messaging/bus.h"
#include "sensor/health.h"

namespace geon::cli {

// Listens to HEALTH_* of every process on the bus.
class HealthWatch {
 public:
  struct Heard {
    sensor::Health health;
    double heard_s = 0.0;  // steady clock
  };

  static Result<std::unique_ptr<HealthWatch>> Open(const std::string& lcm_url);

  // Handles what arrives within this time.
  void Listen(double duration_s);
  // The newest word of a process ("geon-ptu"), or null.
  const Heard* Of(const std::string& process) const;
  // Since a process was last heard.
  static double AgeInSeconds(const Heard& heard);

 private:
  explicit HealthWatch(std::unique_ptr<messaging::Bus> bus);
  std::unique_ptr<messaging::Bus> bus_;
  std::map<std::string, Heard> heard_;
};

// "starting", "ok", "warn", "fault"
std::string ToString(sensor::HealthLevel level);

}  // namespace geon::cli
