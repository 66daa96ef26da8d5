// Conversions of what the base says and is told, and of what every process says about itself.
#include <algorithm>

#include "messaging/wire.h"
#include "messaging/wire_checks.h"

namespace geon::messaging {

geon::base_state_t ToWire(const sensor::BaseState& state) {
  geon::base_state_t wire{};
  wire.utime = state.utime;
  wire.seq = state.seq;
  wire.status = static_cast<int32_t>(state.status);
  wire.x_m = state.x_m;
  wire.y_m = state.y_m;
  wire.heading_rad = state.heading_rad;
  wire.speed_m_s = state.speed_m_s;
  wire.turn_rate_rad_s = state.turn_rate_rad_s;
  wire.moving = state.moving ? 1 : 0;
  wire.stop_reason = static_cast<int32_t>(state.stop);
  wire.command_id = state.command_id;
  return wire;
}

Result<sensor::BaseState> FromWire(const geon::base_state_t& wire) {
  FieldChecks checks;
  sensor::BaseState state;
  state.utime = wire.utime;
  state.seq = wire.seq;
  state.status = checks.Enumeration("status", wire.status, sensor::DeviceStatus::kFault);
  state.x_m = wire.x_m;
  state.y_m = wire.y_m;
  state.heading_rad = wire.heading_rad;
  state.speed_m_s = wire.speed_m_s;
  state.turn_rate_rad_s = wire.turn_rate_rad_s;
  state.moving = wire.moving != 0;
  state.stop = checks.Enumeration("stop_reason", wire.stop_reason, sensor::BaseStop::kLaserOn);
  state.command_id = wire.command_id;
  if (state.status == sensor::DeviceStatus::kReady) {
    checks.Finite("x_m", wire.x_m);
    checks.Finite("y_m", wire.y_m);
    checks.Finite("heading_rad", wire.heading_rad);
  }
  return checks.Finish(state);
}

geon::base_command_t ToWire(const sensor::BaseCommand& command) {
  geon::base_command_t wire{};
  wire.utime = command.utime;
  wire.seq = command.seq;
  wire.command_id = command.command_id;
  wire.state_seq = command.state_seq;
  wire.speed_m_s = command.speed_m_s;
  wire.turn_rate_rad_s = command.turn_rate_rad_s;
  return wire;
}

Result<sensor::BaseCommand> FromWire(const geon::base_command_t& wire) {
  FieldChecks checks;
  checks.Finite("speed_m_s", wire.speed_m_s);
  checks.Finite("turn_rate_rad_s", wire.turn_rate_rad_s);
  return checks.Finish(sensor::BaseCommand{wire.utime, wire.seq, wire.command_id, wire.state_seq,
                                           wire.speed_m_s, wire.turn_rate_rad_s});
}

geon::sonar_t ToWire(const sensor::SonarScan& scan) {
  geon::sonar_t wire{};
  wire.utime = scan.utime;
  wire.seq = scan.seq;
  wire.x_m = scan.x_m;
  wire.y_m = scan.y_m;
  wire.heading_rad = scan.heading_rad;
  std::copy(scan.range_m.begin(), scan.range_m.end(), wire.range_m);
  return wire;
}

Result<sensor::SonarScan> FromWire(const geon::sonar_t& wire) {
  FieldChecks checks;
  sensor::SonarScan scan;
  scan.utime = wire.utime;
  scan.seq = wire.seq;
  scan.x_m = wire.x_m;
  scan.y_m = wire.y_m;
  scan.heading_rad = wire.heading_rad;
  checks.Finite("x_m", wire.x_m);
  checks.Finite("y_m", wire.y_m);
  checks.Finite("heading_rad", wire.heading_rad);
  for (size_t i = 0; i < scan.range_m.size(); ++i) {
    scan.range_m[i] = wire.range_m[i];  // NaN: no echo
    checks.Require(!(scan.range_m[i] < 0.0) && !std::isinf(scan.range_m[i]), "range_m",
                   "holds what is no range");
  }
  return checks.Finish(scan);
}

geon::bumper_t ToWire(const sensor::BumperState& state) {
  geon::bumper_t wire{};
  wire.utime = state.utime;
  wire.seq = state.seq;
  std::transform(state.pressed.begin(), state.pressed.end(), wire.pressed,
                 [](bool pressed) { return static_cast<int8_t>(pressed ? 1 : 0); });
  std::copy(state.bearing_rad.begin(), state.bearing_rad.end(), wire.bearing_rad);
  wire.contact_count = state.contact_count;
  return wire;
}

Result<sensor::BumperState> FromWire(const geon::bumper_t& wire) {
  FieldChecks checks;
  sensor::BumperState state;
  state.utime = wire.utime;
  state.seq = wire.seq;
  for (size_t i = 0; i < state.pressed.size(); ++i) {
    state.pressed[i] = wire.pressed[i] != 0;
    state.bearing_rad[i] = wire.bearing_rad[i];
    checks.Finite("bearing_rad", wire.bearing_rad[i]);
  }
  state.contact_count = wire.contact_count;
  return checks.Finish(state);
}

geon::infrared_t ToWire(const sensor::InfraredScan& scan) {
  geon::infrared_t wire{};
  wire.utime = scan.utime;
  wire.seq = scan.seq;
  std::copy(scan.level.begin(), scan.level.end(), wire.level);
  return wire;
}

Result<sensor::InfraredScan> FromWire(const geon::infrared_t& wire) {
  FieldChecks checks;
  sensor::InfraredScan scan;
  scan.utime = wire.utime;
  scan.seq = wire.seq;
  for (size_t i = 0; i < scan.level.size(); ++i) {
    scan.level[i] = wire.level[i];
    checks.Require(scan.level[i] >= 0 && scan.level[i] <= 15, "level", "is not within 0..15");
  }
  return checks.Finish(scan);
}

geon::health_t ToWire(const sensor::Health& health) {
  geon::health_t wire{};
  wire.utime = health.utime;
  wire.seq = health.seq;
  wire.process = health.process;
  wire.host = health.host;
  wire.pid = health.pid;
  wire.version = health.version;
  wire.config_hash = health.config_hash;
  wire.level = static_cast<int32_t>(health.level);
  wire.text = health.text;
  wire.uptime_s = health.uptime_s;
  wire.loop_hz = health.loop_hz;
  wire.rx_lost = health.rx_lost;
  wire.decode_errors = health.decode_errors;
  wire.max_age_s = health.max_age_s;
  wire.cpu_s = health.cpu_s;
  wire.rss_bytes = health.rss_bytes;
  wire.reconnects = health.reconnects;
  return wire;
}

Result<sensor::Health> FromWire(const geon::health_t& wire) {
  FieldChecks checks;
  sensor::Health health;
  health.utime = wire.utime;
  health.seq = wire.seq;
  health.process = wire.process;
  health.host = wire.host;
  health.pid = wire.pid;
  health.version = wire.version;
  health.config_hash = wire.config_hash;
  health.level = checks.Enumeration("level", wire.level, sensor::HealthLevel::kFault);
  health.text = wire.text;
  health.uptime_s = wire.uptime_s;
  health.loop_hz = wire.loop_hz;
  health.rx_lost = wire.rx_lost;
  health.decode_errors = wire.decode_errors;
  health.max_age_s = wire.max_age_s;
  health.cpu_s = wire.cpu_s;
  health.rss_bytes = wire.rss_bytes;
  health.reconnects = wire.reconnects;
  return checks.Finish(std::move(health));
}

geon::session_t ToWire(const sensor::Session& session) {
  geon::session_t wire{};
  wire.utime = session.utime;
  wire.seq = session.seq;
  wire.process = session.process;
  wire.host = session.host;
  wire.start_utime = session.start_utime;
  wire.version = session.version;
  wire.config_hash = session.config_hash;
  wire.calibration_hash = session.calibration_hash;
  wire.calibration_file = session.calibration_file;
  wire.types_hash = session.types_hash;
  return wire;
}

Result<sensor::Session> FromWire(const geon::session_t& wire) {
  return sensor::Session{wire.utime,
                         wire.seq,
                         wire.process,
                         wire.host,
                         wire.start_utime,
                         wire.version,
                         wire.config_hash,
                         wire.calibration_hash,
                         wire.calibration_file,
                         wire.types_hash};
}

}  // namespace geon::messaging
