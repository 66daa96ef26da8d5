#include "sim/nomad_emulator.h"

#include <algorithm>
#include <cmath>

namespace geon::sim {
namespace {

constexpr double kNomadTick_s = 0.001;
constexpr int kTicksPerStep = 4;  // of the body: 250 steps a second
constexpr double kTenthInch_m = 0.00254;
constexpr double kTenthDegree_rad = kPi / 1800.0;
constexpr double kClock_ms = 16.4;
constexpr double kZeroingLimit_s = 120.0;
constexpr double kCpuFullScale_V = 12.0;
constexpr double kMotorFullScale_V = 12.85;

double UnitOf(Servo servo) {
  return servo == Servo::kTranslation ? kTenthInch_m : kTenthDegree_rad;
}

int Tenths(double value, double unit) { return static_cast<int>(std::lround(value / unit)); }

RingPose TurretPose(const SynchroDrive& drive) {
  return {drive.center_W_m(), drive.turret_W_rad(), drive.tilt_W()};
}

NomadFrame Nak() { return {static_cast<uint8_t>(NomadType::kNak), {}}; }

}  // namespace

NomadEmulator::NomadEmulator(const NomadEmulatorOptions& options, const Surroundings* surroundings)
    : options_(options),
      drive_(options.drive, surroundings),
      sonar_(options.sonar, options.seed, surroundings),
      bumpers_(options.bumpers, options.seed + 1),
      infrared_(options.infrared, options.seed + 2, surroundings),
      from_host_(options.baud),
      to_host_(options.baud) {}

void NomadEmulator::PowerCycle(double time_s) {
  Advance(time_s);
  drive_.PowerCycle();
  sonar_.PowerCycle(now_s_);
  infrared_.PowerCycle();
  reader_.Reset();
  from_host_.Clear();
  to_host_.Clear();
  mask_ = {};
  compass_on_ = true;
  dead_man_s_ = 0.0;
  waiting_ = Waiting::kNone;
  last_command_s_ = power_up_s_ = now_s_;
}

void NomadEmulator::Receive(std::span<const uint8_t> bytes, double time_s) {
  from_host_.Push(bytes, time_s);
}

std::vector<uint8_t> NomadEmulator::Transmit(double time_s) { return to_host_.PopAll(time_s); }

void NomadEmulator::Advance(double time_s) {
  while (static_cast<double>(ticks_ + 1) * kNomadTick_s <= time_s) Tick();
}

void NomadEmulator::Tick() {
  ++ticks_;
  now_s_ = static_cast<double>(ticks_) * kNomadTick_s;
  if (ticks_ % kTicksPerStep == 0) {
    drive_.Step(kTicksPerStep * kNomadTick_s);
    sonar_.Advance(now_s_, TurretPose(drive_));
    infrared_.Advance(now_s_, TurretPose(drive_));
  }
  bumpers_.Advance(now_s_, drive_.contacts(), drive_.base_W_rad());
  if (dead_man_s_ > 0.0 && now_s_ - last_command_s_ > dead_man_s_) StopAll();
  StepWaiting();
  while (const auto byte = from_host_.Pop(now_s_)) {
    if (now_s_ - last_byte_s_ > options_.byte_timeout_s) reader_.Reset();
    last_byte_s_ = now_s_;
    for (const NomadFrame& frame : reader_.Push(*byte)) HandleFrame(frame);
  }
}

void NomadEmulator::HandleFrame(const NomadFrame& frame) {
  // One reply for each command, in order: a new command ends the wait of the one before.
  EndWaiting();
  last_command_s_ = now_s_;
  if (!WellFormed(frame)) {
    Send(Nak());
  } else if (const auto reply = Execute(frame)) {
    Send(*reply);
  }
}

std::optional<NomadFrame> NomadEmulator::Execute(const NomadFrame& frame) {
  switch (static_cast<NomadType>(frame.type)) {
    case NomadType::kZero:
    case NomadType::kWaitStop:
      StartWaiting(frame);
      return std::nullopt;
    case NomadType::kAcceleration:
    case NomadType::kSpeed:
    case NomadType::kMoveRelative:
    case NomadType::kMoveAbsolute:
    case NomadType::kVelocity:
    case NomadType::kStop:
    case NomadType::kLimp:
    case NomadType::kMoveServos:
      return ExecuteMotion(frame);
    case NomadType::kGetInfrared:
    case NomadType::kGetSonar:
    case NomadType::kGetConfiguration:
    case NomadType::kGetVelocity:
    case NomadType::kGetAcceleration:
    case NomadType::kGetCompass:
    case NomadType::kGetLaser:
    case NomadType::kGetBumper:
    case NomadType::kGetScan:
      return ExecuteQuery(frame);
    default:
      return ExecuteConfiguration(frame);
  }
}

std::optional<NomadFrame> NomadEmulator::ExecuteMotion(const NomadFrame& frame) {
  const auto type = static_cast<NomadType>(frame.type);
  const auto& payload = frame.payload;
  if (type == NomadType::kMoveServos) {
    for (const size_t offset : {0u, 4u, 8u}) {
      if (NomadUnsigned(payload, offset) > static_cast<int>(ServoMode::kAbsolute)) return Nak();
    }
    MoveServos(payload);
  } else if (type == NomadType::kStop) {
    StopAll();
  } else if (type == NomadType::kLimp) {
    for (const Servo servo : kServos) drive_.Limp(servo);
  } else if (type == NomadType::kAcceleration || type == NomadType::kSpeed) {
    const ServoMode mode = type == NomadType::kSpeed ? ServoMode::kSpeed : ServoMode::kAcceleration;
    for (const Servo servo : kServos) {
      MoveServo(servo, mode, NomadUnsigned(payload, 2 * static_cast<size_t>(servo)));
    }
  } else {
    const ServoMode mode = type == NomadType::kVelocity       ? ServoMode::kVelocity
                           : type == NomadType::kMoveRelative ? ServoMode::kRelative
                                                              : ServoMode::kAbsolute;
    if (type == NomadType::kMoveAbsolute) {
      drive_.TieTurret(false);
    } else {
      TieTurretFor(NomadSigned(payload, 2), NomadSigned(payload, 4));
    }
    for (const Servo servo : kServos) {
      MoveServo(servo, mode, NomadSigned(payload, 2 * static_cast<size_t>(servo)));
    }
  }
  return StateReply(frame.type);
}

void NomadEmulator::TieTurretFor(int steering, int turret) {
  drive_.TieTurret(options_.turret_follows_steering && (turret == 0 || turret == steering));
}

void NomadEmulator::MoveServos(const std::vector<uint8_t>& payload) {
  const auto mode = [&](Servo servo) {
    return static_cast<ServoMode>(NomadUnsigned(payload, 4 * static_cast<size_t>(servo)));
  };
  const auto value = [&](Servo servo) {
    return NomadSigned(payload, 4 * static_cast<size_t>(servo) + 2);
  };
  const auto moves = [](ServoMode m) {
    return m == ServoMode::kVelocity || m == ServoMode::kRelative || m == ServoMode::kAbsolute;
  };
  const ServoMode turret = mode(Servo::kTurret);
  if (moves(turret) && turret == mode(Servo::kSteering) && turret != ServoMode::kAbsolute) {
    TieTurretFor(value(Servo::kSteering), value(Servo::kTurret));
  } else if (moves(turret)) {
    drive_.TieTurret(false);
  } else if (turret == ServoMode::kIgnore && moves(mode(Servo::kSteering)) &&
             !drive_.moving(Servo::kTurret)) {
    TieTurretFor(value(Servo::kSteering), 0);
  }
  for (const Servo servo : kServos) MoveServo(servo, mode(servo), value(servo));
}

void NomadEmulator::MoveServo(Servo servo, ServoMode mode, double value) {
  // A turret that is tied to the steering moves with it and has no motion of its own.
  const bool tied = servo == Servo::kTurret && drive_.turret_tied();
  const double amount = value * UnitOf(servo);
  switch (mode) {
    case ServoMode::kVelocity:
      if (!tied) drive_.RunAt(servo, amount);
      break;
    case ServoMode::kRelative:
      if (!tied) drive_.MoveBy(servo, amount);
      break;
    case ServoMode::kAbsolute:
      if (!tied) drive_.MoveTo(servo, amount);
      break;
    case ServoMode::kLimp:
      drive_.Limp(servo);
      break;
    case ServoMode::kAcceleration:
      drive_.SetAcceleration(servo, amount);
      break;
    case ServoMode::kSpeed:
      drive_.SetSpeed(servo, amount);
      break;
    case ServoMode::kIgnore:
      break;
  }
}

void NomadEmulator::StopAll() {
  for (const Servo servo : kServos) drive_.Hold(servo);
}

std::optional<NomadFrame> NomadEmulator::ExecuteConfiguration(const NomadFrame& frame) {
  const auto& payload = frame.payload;
  switch (static_cast<NomadType>(frame.type)) {
    case NomadType::kGetState:
    case NomadType::kTalk:            // nobody listens to the voice here
    case NomadType::kConfigureLaser:  // no laser ranger is fitted
    case NomadType::kConfigureScan:
      break;
    case NomadType::kMask:
      std::copy(payload.begin(), payload.end(), mask_.begin());
      break;
    case NomadType::kDefinePosition:
      drive_.DefinePosition(kTenthInch_m *
                            Eigen::Vector2d(NomadSigned(payload, 0), NomadSigned(payload, 2)));
      break;
    case NomadType::kDefineAngles:
      drive_.DefineAngle(Servo::kSteering, kTenthDegree_rad * NomadSigned(payload, 0));
      drive_.DefineAngle(Servo::kTurret, kTenthDegree_rad * NomadSigned(payload, 2));
      break;
    case NomadType::kConfigureInfrared:
      infrared_.Configure(payload[0], {payload.begin() + 1, payload.end()});
      break;
    case NomadType::kConfigureSonar:
      sonar_.Configure(payload[0], {payload.begin() + 1, payload.end()}, now_s_);
      break;
    case NomadType::kConfigureCompass:
      compass_on_ = payload[0] != 0;
      break;
    case NomadType::kConfigureTimeout:
      dead_man_s_ = payload[0];
      break;
    default:
      return Nak();
  }
  return StateReply(frame.type);
}

std::optional<NomadFrame> NomadEmulator::ExecuteQuery(const NomadFrame& frame) const {
  const NomadState state = Measure();
  NomadFrame reply{frame.type, {}};
  bool timed = true;
  switch (static_cast<NomadType>(frame.type)) {
    case NomadType::kGetInfrared:
      AppendNomadInfrared(state, 0xffff, &reply.payload);
      break;
    case NomadType::kGetSonar:
      reply.payload.assign(state.sonar_in.begin(), state.sonar_in.end());
      break;
    case NomadType::kGetBumper:
      AppendNomadBumpers(state, &reply.payload);
      break;
    case NomadType::kGetCompass:
      AppendNomadSigned(state.compass, &reply.payload);
      break;
    case NomadType::kGetConfiguration:
      for (const int value : state.configuration) AppendNomadSigned(value, &reply.payload);
      timed = false;
      break;
    case NomadType::kGetVelocity:
      for (const int value : state.velocity) AppendNomadSigned(value, &reply.payload);
      timed = false;
      break;
    case NomadType::kGetAcceleration:
      for (const Servo servo : kServos) {
        AppendNomadUnsigned(Tenths(drive_.acceleration(servo), UnitOf(servo)), &reply.payload);
      }
      timed = false;
      break;
    default:  // GET_LS and GET_SG: no points, no lines
      AppendNomadUnsigned(0, &reply.payload);
      break;
  }
  if (timed) AppendNomadUnsigned32(state.time_ms, &reply.payload);
  return reply;
}

void NomadEmulator::StartWaiting(const NomadFrame& frame) {
  waiting_type_ = frame.type;
  if (static_cast<NomadType>(frame.type) == NomadType::kZero) {
    waiting_ = Waiting::kZeroed;
    waits_for_ = {true, true, true};
    wait_until_s_ = now_s_ + kZeroingLimit_s;
    StartZeroing();
    return;
  }
  waiting_ = Waiting::kStopped;
  for (size_t i = 0; i < 3; ++i) waits_for_[i] = frame.payload[i] != 0;
  wait_until_s_ = now_s_ + frame.payload[3];
}

// Steering and turret turn until they point where bumper 0 is.
void NomadEmulator::StartZeroing() {
  drive_.TieTurret(false);
  drive_.Hold(Servo::kTranslation);
  drive_.MoveBy(Servo::kSteering, WrapAngle(drive_.base_W_rad() - drive_.heading_W_rad()));
  drive_.MoveBy(Servo::kTurret, WrapAngle(drive_.base_W_rad() - drive_.turret_W_rad()));
}

void NomadEmulator::StepWaiting() {
  if (waiting_ == Waiting::kNone) return;
  const bool moves = std::any_of(kServos.begin(), kServos.end(), [&](Servo servo) {
    return waits_for_[static_cast<size_t>(servo)] && drive_.moving(servo);
  });
  if (moves && now_s_ < wait_until_s_) return;
  if (waiting_ == Waiting::kZeroed && !moves) {
    drive_.DefinePosition(Eigen::Vector2d::Zero());
    drive_.DefineAngle(Servo::kSteering, 0.0);
    drive_.DefineAngle(Servo::kTurret, 0.0);
  }
  EndWaiting();
}

void NomadEmulator::EndWaiting() {
  if (waiting_ == Waiting::kNone) return;
  waiting_ = Waiting::kNone;
  Send(StateReply(waiting_type_));
}

NomadState NomadEmulator::Measure() const {
  NomadState state;
  state.infrared = infrared_.levels();
  state.sonar_in = sonar_.readings_in();
  state.bumpers = bumpers_.mask();
  state.configuration = {Tenths(drive_.odometry_m().x(), kTenthInch_m),
                         Tenths(drive_.odometry_m().y(), kTenthInch_m),
                         Tenths(WrapAngle(drive_.position(Servo::kSteering)), kTenthDegree_rad),
                         Tenths(WrapAngle(drive_.position(Servo::kTurret)), kTenthDegree_rad)};
  for (const Servo servo : kServos) {
    const auto i = static_cast<size_t>(servo);
    state.velocity[i] = Tenths(drive_.velocity(servo), UnitOf(servo));
    if (drive_.moving(servo)) state.motors_active |= static_cast<uint8_t>(1u << i);
  }
  // North is the y axis of W.
  if (compass_on_)
    state.compass = Tenths(WrapAngle(drive_.turret_W_rad() - kPi / 2), kTenthDegree_rad);
  const double clock_ticks = std::floor((now_s_ - power_up_s_) * 1000.0 / kClock_ms);
  state.time_ms = static_cast<uint32_t>(clock_ticks * kClock_ms);
  state.cpu_volts_raw = NomadRawVolts(options_.cpu_battery_V, kCpuFullScale_V);
  state.motor_volts_raw = NomadRawVolts(options_.motor_battery_V, kMotorFullScale_V);
  return state;
}

NomadFrame NomadEmulator::StateReply(uint8_t type) const {
  return {type, EncodeNomadState(Measure(), mask_)};
}

void NomadEmulator::Send(const NomadFrame& frame) {
  to_host_.Push(EncodeNomadFrame(frame), now_s_ + options_.reply_latency_s);
}

}  // namespace geon::sim
