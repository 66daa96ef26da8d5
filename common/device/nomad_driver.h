#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "device/nomad_codec.h"
#include "sensor/base.h"
#include "sensor/device_status.h"

namespace geon::device {

struct NomadDriverOptions {
  double poll_period_s = 0.05;
  double reply_timeout_s = 0.15;  // a full state takes 15 ms at 38400 baud
  double quiet_s = 0.05;          // silence that ends a resynchronisation
  int dead_man_s = 1;  // CONF_TM: the robot stops by itself without commands; whole seconds
  double acceleration_m_s2 = 0.762;        // 30 in/s^2; a stop (ST) brakes as hard as the robot can
  double turn_acceleration_rad_s2 = 1.05;  // 60 degrees/s^2
  double speed_limit_m_s = 0.5;
  double turn_rate_limit_rad_s = 1.0471975511965976;  // 60 degrees/s
  int sonar_rate = 15;                                // x 4 ms from one sonar to the next
  std::array<int, sensor::kSonarCount> sonar_order = {0,  2, 15, 1, 14, 3, 13, 4,
                                                      12, 5, 11, 6, 10, 7, 9,  8};
  double turret_gain_per_s = 1.0;  // how fast the turret is led back to the steering while driving
};

// One state packet in SI. W is where the robot's odometry started; it goes on where it was when the
// robot restarts.
struct NomadSample {
  double time_s = 0.0;  // when it had arrived
  double x_m = 0.0, y_m = 0.0;
  double steer_rad = 0.0, turret_rad = 0.0;
  double speed_m_s = 0.0, turn_rate_rad_s = 0.0, turret_rate_rad_s = 0.0;
  std::array<double, sensor::kSonarCount> sonar_m{};  // NaN: no echo
  std::array<int, sensor::kInfraredCount> infrared{};
  std::array<bool, sensor::kBumperCount> bumper{};
  bool moving = false;
  double cpu_volts = 0.0, motor_volts = 0.0;
};

struct NomadReport {
  sensor::DeviceStatus status = sensor::DeviceStatus::kUnknown;
  std::string text;  // why, when not ready
  int samples = 0;   // since start; the newest:
  NomadSample sample;
  bool halted = false;  // the robot has confirmed the stop asked for, and stands
  int recoveries = 0;   // times it had to be set up again on an open line
  int restarts = 0;     // of the robot, seen by its clock
};

// Drives the Nomad 200 base over its direct serial line.
//
// A state machine without clock and port: the caller reports the line's fate (Connected,
// Disconnected) and calls Step often with the time of a monotonic clock and what arrived; Step
// returns what to send. One request is outstanding, with a deadline; every reply's type, length and
// checksum are checked. Driving re-sends the velocities at the poll rate, standing asks for the
// state; a stop goes out as soon as the line is free and is repeated until the robot stands. After
// one missing or unfit reply the state is asked for again; after two in a row, a restart of the
// robot or a forgotten mask the setup is done anew, beginning with a stop, and the robot stays
// stopped until Drive is called once more.
class NomadDriver {
 public:
  explicit NomadDriver(const NomadDriverOptions& options = {});

  // Velocities until changed, clamped to the limits; the turret turns with the steering. Without
  // effect unless ready.
  void Drive(double speed_m_s, double turn_rate_rad_s);
  void Halt();

  void Connected(double time_s);
  void Disconnected(double time_s);
  [[nodiscard]] std::string Step(double time_s, std::string_view bytes_in);

  const NomadReport& report() const { return report_; }

 private:
  enum class Phase { kClosed, kQuiet, kSetup, kRunning };
  static constexpr int kMaskStep = 1;
  static constexpr int kSetupSteps = 7;  // ST CT CONF_TM CONF_SN AC SP GS
  struct Velocity {
    double speed_m_s = 0.0;
    double turn_rate_rad_s = 0.0;
    friend bool operator==(const Velocity&, const Velocity&) = default;
  };

  void Receive(double time_s, std::string_view bytes);
  void HandleFrame(double time_s, const NomadFrame& frame);
  void TakeState(double time_s, const NomadState& state);
  void Fail(double time_s, const std::string& what);
  void StartOver(double time_s, const std::string& why);
  std::string SendNext(double time_s);
  std::string Send(double time_s, NomadType type, std::string frame);
  std::string SendSetup(double time_s);
  std::string VelocityFrame() const;
  bool SeemsRestarted(double time_s, const NomadState& state) const;
  void MendOdometry(const NomadState& state);

  NomadDriverOptions options_;
  NomadMask mask_;
  NomadReport report_;
  NomadReader reader_;
  Phase phase_ = Phase::kClosed;
  int setup_step_ = 0;
  bool set_up_ = false;
  std::optional<NomadType> outstanding_;
  double deadline_s_ = 0.0;
  double phase_since_s_ = 0.0;
  double last_byte_s_ = 0.0;
  double next_poll_s_ = 0.0;
  int failures_ = 0;                  // in a row
  std::optional<Velocity> velocity_;  // nothing: halt
  bool send_at_once_ = false;
  bool stop_confirmed_ = false;
  std::optional<uint32_t> robot_time_ms_;  // of the newest sample
  bool odometry_broken_ = false;           // the robot restarted since
  // Pose in W of the origin of the robot's own odometry.
  double origin_x_m_ = 0.0, origin_y_m_ = 0.0, origin_heading_rad_ = 0.0;
};

}  // namespace geon::device
