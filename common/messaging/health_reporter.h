#pragma once

#include <string>
#include <string_view>

#include "messaging/bus.h"
#include "messaging/poll_loop.h"
#include "sensor/health.h"

namespace geon::messaging {

// HEALTH_<PROCESS>: "geon-ptu" -> HEALTH_PTU, "geon-color-camera-head" -> HEALTH_COLOR_CAMERA_HEAD.
std::string HealthChannel(std::string_view process);

struct HealthIdentity {
  std::string process;  // "geon-ptu"
  std::string version;
  std::string config_hash;
};

// Publishes the process's health once a second and GEON_SESSION every five: construct it once the
// bus and the loop exist; it hangs itself into the loop and must outlive Run(). The daemon tells it
// what it knows: level and reason, reconnects, ages of inputs. Starts as kStarting.
class HealthReporter {
 public:
  HealthReporter(Bus* bus, PollLoop* loop, HealthIdentity identity);

  // A level, kept until changed.
  void SetLevel(sensor::HealthLevel level, const std::string& text = "");
  void CountReconnect() { ++health_.reconnects; }
  void set_reconnects(int32_t reconnects) { health_.reconnects = reconnects; }
  // Age of an input at its use; the largest of each second is reported.
  void ReportAge(double age_s);
  // The calibration in use goes into GEON_SESSION.
  void SetCalibration(const std::string& hash, const std::string& file);

  sensor::HealthLevel level() const { return health_.level; }

 private:
  void PublishHealth();
  void PublishSession();

  Bus* bus_;
  PollLoop* loop_;
  std::string channel_;
  sensor::Health health_;
  sensor::Session session_;
  double start_s_;
  double last_s_;
  int64_t last_rounds_ = 0;
};

}  // namespace geon::messaging
