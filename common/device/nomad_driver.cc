#include "device/nomad_driver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::device {
namespace {

constexpr double kMetresPerUnit = 0.1 * kMetresPerInch;
constexpr double kRadiansPerUnit = 0.1 * kPi / 180.0;
constexpr int kNoEcho = 255;
constexpr int kNomadFailuresUntilFault = 10;
constexpr double kLongestNomadNoise_s = 1.0;  // a line that is never quiet is used after this
constexpr double kTurretTolerance_rad = 0.005;

// Towards zero: a limit is never exceeded by rounding.
int UnitsTowardsZero(double value, double unit) {
  return static_cast<int>(std::trunc(value / unit + (value < 0 ? -1e-9 : 1e-9)));
}
int Units(double value, double unit) { return static_cast<int>(std::lround(value / unit)); }

double Volts(int raw, double range_v) { return (2.0 + 3.0 * raw / 255.0) * range_v / 5.0; }

}  // namespace

NomadDriver::NomadDriver(const NomadDriverOptions& options) : options_(options) {
  Require(options.poll_period_s > 0.0 && options.reply_timeout_s > 0.0 && options.quiet_s > 0.0,
          "NomadDriverOptions: every time must be positive");
  Require(options.dead_man_s >= 1 && options.dead_man_s >= 3.0 * options.poll_period_s,
          "NomadDriverOptions: the dead-man time must be at least 1 s and 3 polls");
  Require(options.acceleration_m_s2 > 0.0 && options.turn_acceleration_rad_s2 > 0.0 &&
              options.speed_limit_m_s > 0.0 && options.turn_rate_limit_rad_s > 0.0,
          "NomadDriverOptions: limits must be positive");
  report_.text = "no line to the base yet";
}

void NomadDriver::Drive(double speed_m_s, double turn_rate_rad_s) {
  if (report_.status != sensor::DeviceStatus::kReady) return;
  Require(std::isfinite(speed_m_s) && std::isfinite(turn_rate_rad_s), "velocities must be finite");
  const Velocity velocity{
      std::clamp(speed_m_s, -options_.speed_limit_m_s, options_.speed_limit_m_s),
      std::clamp(turn_rate_rad_s, -options_.turn_rate_limit_rad_s, options_.turn_rate_limit_rad_s)};
  if (velocity_ != velocity) send_at_once_ = true;
  velocity_ = velocity;
  stop_confirmed_ = report_.halted = false;
}

void NomadDriver::Halt() {
  if (velocity_) {
    send_at_once_ = true;
    stop_confirmed_ = report_.halted = false;
  }
  velocity_.reset();
}

void NomadDriver::Connected(double time_s) {
  failures_ = 0;
  StartOver(time_s, "starting");
}

void NomadDriver::Disconnected(double time_s) {
  StartOver(time_s, "the line to the base is gone");
  phase_ = Phase::kClosed;
  report_.status = sensor::DeviceStatus::kUnknown;
}

// The robot is set up anew, a stop first. Whoever wants to drive must say so again.
void NomadDriver::StartOver(double time_s, const std::string& why) {
  if (phase_ == Phase::kRunning) ++report_.recoveries;
  phase_ = Phase::kQuiet;
  phase_since_s_ = last_byte_s_ = time_s;
  setup_step_ = 0;
  outstanding_.reset();
  reader_.Clear();
  velocity_.reset();
  send_at_once_ = stop_confirmed_ = report_.halted = false;
  set_up_ = false;
  report_.text = why;
  report_.status = failures_ >= kNomadFailuresUntilFault ? sensor::DeviceStatus::kFault
                                                         : sensor::DeviceStatus::kStarting;
}

void NomadDriver::Fail(double time_s, const std::string& what) {
  ++failures_;
  outstanding_.reset();
  // Once may be noise: ask again, when the line is quiet, for what can be asked twice.
  if (failures_ == 1 && set_up_) {
    phase_ = Phase::kQuiet;
    phase_since_s_ = last_byte_s_ = time_s;
    reader_.Clear();
    report_.text = what;
    return;
  }
  StartOver(time_s,
            failures_ < kNomadFailuresUntilFault ? what : what + " (38400 baud, switched on?)");
}

std::string NomadDriver::Step(double time_s, std::string_view bytes_in) {
  if (phase_ == Phase::kClosed) return {};
  if (!bytes_in.empty()) last_byte_s_ = time_s;
  Receive(time_s, bytes_in);
  if (outstanding_ && time_s >= deadline_s_) Fail(time_s, "the base does not answer");
  if (phase_ == Phase::kQuiet) {
    const bool quiet = time_s - last_byte_s_ >= options_.quiet_s;
    if (!quiet && time_s - phase_since_s_ < kLongestNomadNoise_s) return {};
    reader_.Clear();
    phase_ = set_up_ ? Phase::kRunning : Phase::kSetup;
    next_poll_s_ = time_s;
  }
  return SendNext(time_s);
}

void NomadDriver::Receive(double time_s, std::string_view bytes) {
  reader_.Push(bytes);
  while (const std::optional<NomadFrame> frame = reader_.Next()) {
    if (phase_ == Phase::kQuiet) continue;
    HandleFrame(time_s, *frame);
  }
}

void NomadDriver::HandleFrame(double time_s, const NomadFrame& frame) {
  if (!outstanding_) return Fail(time_s, "the base sent a frame unasked");
  if (frame.type == NomadType::kRefused) return Fail(time_s, "the base refused a command");
  if (frame.type != *outstanding_) return Fail(time_s, "the base answered something else");
  const NomadType type = *std::exchange(outstanding_, std::nullopt);
  // Until the mask has been taken, replies have whatever length they had.
  const bool before_mask = phase_ == Phase::kSetup && setup_step_ <= kMaskStep;
  const std::optional<NomadState> state = DecodeNomadState(frame.payload, mask_);
  if (!state && !before_mask) {
    ++failures_;
    return StartOver(time_s, "the base forgot its setup");
  }
  if (phase_ == Phase::kSetup) {
    ++setup_step_;
    if (setup_step_ < kSetupSteps) return;
    if (!state) return;
    phase_ = Phase::kRunning;
    set_up_ = true;
    next_poll_s_ = time_s;
  }
  failures_ = 0;
  if (SeemsRestarted(time_s, *state)) {
    ++report_.restarts;
    odometry_broken_ = true;
    robot_time_ms_.reset();
    if (report_.status == sensor::DeviceStatus::kReady) {
      return StartOver(time_s, "the base restarted");
    }
  }
  if (odometry_broken_) MendOdometry(*state);
  robot_time_ms_ = state->time_ms;
  if (type == NomadType::kStop && !velocity_) stop_confirmed_ = true;
  TakeState(time_s, *state);
}

// By the robot's own clock: it never runs backwards, nor stands still while we cannot hear it.
bool NomadDriver::SeemsRestarted(double time_s, const NomadState& state) const {
  constexpr double kClockTolerance_s = 2.0;
  if (!robot_time_ms_) return false;
  const double passed_s = (static_cast<double>(state.time_ms) - *robot_time_ms_) * 1e-3;
  const bool was_away = report_.status != sensor::DeviceStatus::kReady;
  return passed_s < 0.0 ||
         (was_away && passed_s + kClockTolerance_s < time_s - report_.sample.time_s);
}

// A robot that restarts counts from (0, 0, 0) again, where it stands: W goes on from the last pose.
void NomadDriver::MendOdometry(const NomadState& state) {
  odometry_broken_ = false;
  const NomadSample& last = report_.sample;
  const double x_m = state.configuration->x * kMetresPerUnit;
  const double y_m = state.configuration->y * kMetresPerUnit;
  origin_heading_rad_ = WrapAngle(last.steer_rad - state.configuration->steer * kRadiansPerUnit);
  const double c = std::cos(origin_heading_rad_);
  const double s = std::sin(origin_heading_rad_);
  origin_x_m_ = last.x_m - (c * x_m - s * y_m);
  origin_y_m_ = last.y_m - (s * x_m + c * y_m);
}

void NomadDriver::TakeState(double time_s, const NomadState& state) {
  NomadSample sample;
  sample.time_s = time_s;
  const double x_m = state.configuration->x * kMetresPerUnit;
  const double y_m = state.configuration->y * kMetresPerUnit;
  const double c = std::cos(origin_heading_rad_);
  const double s = std::sin(origin_heading_rad_);
  sample.x_m = origin_x_m_ + c * x_m - s * y_m;
  sample.y_m = origin_y_m_ + s * x_m + c * y_m;
  sample.steer_rad = WrapAngle(origin_heading_rad_ + state.configuration->steer * kRadiansPerUnit);
  sample.turret_rad =
      WrapAngle(origin_heading_rad_ + state.configuration->turret * kRadiansPerUnit);
  sample.speed_m_s = state.velocity->translation * kMetresPerUnit;
  sample.turn_rate_rad_s = state.velocity->steer * kRadiansPerUnit;
  sample.turret_rate_rad_s = state.velocity->turret * kRadiansPerUnit;
  sample.moving =
      state.velocity->translation != 0 || state.velocity->steer != 0 || state.velocity->turret != 0;
  for (size_t i = 0; i < sample.sonar_m.size(); ++i) {
    const int range_in = *state.sonar_in[i];
    sample.sonar_m[i] =
        range_in == kNoEcho ? std::numeric_limits<double>::quiet_NaN() : range_in * kMetresPerInch;
    sample.infrared[i] = *state.infrared[i];
  }
  for (size_t i = 0; i < sample.bumper.size(); ++i) sample.bumper[i] = *state.bumpers >> i & 1;
  sample.cpu_volts = Volts(state.cpu_volts_raw, 12.0);
  sample.motor_volts = Volts(state.motor_volts_raw, 12.85);
  ++report_.samples;
  report_.sample = sample;
  report_.halted = stop_confirmed_ && !velocity_ && !sample.moving;
  report_.status = sensor::DeviceStatus::kReady;
  report_.text.clear();
}

std::string NomadDriver::SendNext(double time_s) {
  if (outstanding_ || (phase_ != Phase::kSetup && phase_ != Phase::kRunning)) return {};
  if (phase_ == Phase::kSetup) return SendSetup(time_s);
  if (time_s < next_poll_s_ && !send_at_once_) return {};
  next_poll_s_ = std::max(next_poll_s_ + options_.poll_period_s, time_s);
  send_at_once_ = false;
  if (velocity_) return Send(time_s, NomadType::kVelocity, VelocityFrame());
  // A stop is repeated until the robot stands.
  if (!report_.halted) return Send(time_s, NomadType::kStop, EncodeNomadFrame(NomadType::kStop));
  return Send(time_s, NomadType::kState, EncodeNomadFrame(NomadType::kState));
}

std::string NomadDriver::Send(double time_s, NomadType type, std::string frame) {
  outstanding_ = type;
  deadline_s_ = time_s + options_.reply_timeout_s;
  return frame;
}

std::string NomadDriver::SendSetup(double time_s) {
  const int acceleration = Units(options_.acceleration_m_s2, kMetresPerUnit);
  const int turning = Units(options_.turn_acceleration_rad_s2, kRadiansPerUnit);
  const int speed = UnitsTowardsZero(options_.speed_limit_m_s, kMetresPerUnit);
  const int turn_rate = UnitsTowardsZero(options_.turn_rate_limit_rad_s, kRadiansPerUnit);
  switch (setup_step_) {
    case 0:
      return Send(time_s, NomadType::kStop, EncodeNomadFrame(NomadType::kStop));
    case kMaskStep:
      return Send(time_s, NomadType::kMask, EncodeMask(mask_));
    case 2:
      return Send(time_s, NomadType::kTimeout, EncodeTimeout(options_.dead_man_s));
    case 3:
      return Send(time_s, NomadType::kSonarOrder,
                  EncodeSonarOrder(options_.sonar_rate, options_.sonar_order));
    case 4:
      return Send(time_s, NomadType::kAcceleration,
                  EncodeAcceleration(acceleration, turning, turning));
    case 5:
      return Send(time_s, NomadType::kSpeed, EncodeSpeed(speed, turn_rate, turn_rate));
    default:
      return Send(time_s, NomadType::kState, EncodeNomadFrame(NomadType::kState));
  }
}

// The turret turns with the steering, and is led back to it where the two have drifted apart.
std::string NomadDriver::VelocityFrame() const {
  const double limit = options_.turn_rate_limit_rad_s;
  double behind_rad = WrapAngle(report_.sample.steer_rad - report_.sample.turret_rad);
  if (std::abs(behind_rad) < kTurretTolerance_rad) behind_rad = 0.0;
  const double turret_rate_rad_s = std::clamp(
      velocity_->turn_rate_rad_s + options_.turret_gain_per_s * behind_rad, -limit, limit);
  return EncodeVelocity(UnitsTowardsZero(velocity_->speed_m_s, kMetresPerUnit),
                        UnitsTowardsZero(velocity_->turn_rate_rad_s, kRadiansPerUnit),
                        UnitsTowardsZero(turret_rate_rad_s, kRadiansPerUnit));
}

}  // namespace geon::device
