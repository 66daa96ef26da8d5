#include "sim/ptu_commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace geon::sim {
namespace {

constexpr int kLargestCount = 32767;
constexpr double kSlowestSpeed = 31.0;
constexpr double kSlowestBaseSpeed = 57.0;
constexpr int kFastestAcceleration = 200000;
constexpr int kLargestUnitId = 127;

constexpr char kVersion[] =
    "Pan-Tilt Controller v2.12.1d1(C14/E), (C)2003 Directed Perception, Inc., All Rights Reserved";
constexpr char kMenu[] =
    "\r\n  PAN/TILT: [P|T]P position  O offset  S speed  D delta speed  A acceleration"
    "\r\n            B base speed  U upper  L lower speed  R resolution  N min  X max"
    "\r\n  H halt  A await  I immediate  S slaved  L limits  C control mode  M monitor"
    "\r\n  R reset  D[S|R|F] defaults  E echo  F feedback  O power and heat  U unit  V version";

PtuReply Done() { return {}; }
PtuReply Says(std::string text) { return {true, std::move(text), PtuReply::When::kNow, 0.0}; }
PtuReply Refuses(std::string why) { return {false, std::move(why), PtuReply::When::kNow, 0.0}; }
PtuReply IllegalCommand() { return Refuses("Illegal Command Entered"); }
PtuReply IllegalArgument() { return Refuses("Illegal argument"); }

std::string Whole(double value) { return std::to_string(std::lround(value)); }

// Which axis a command is about, and how it is called.
struct Subject {
  PtuAxisId id;
  std::string name;
};
Subject SubjectOf(const PtuCommand& command) {
  return command.letters[0] == 'P' ? Subject{PtuAxisId::kPan, "Pan"}
                                   : Subject{PtuAxisId::kTilt, "Tilt"};
}

PtuReply SetPosition(const PtuCommand& command, const Subject& subject, PtuUnit& unit) {
  if (unit.settings().velocity_mode) return IllegalCommand();
  const PtuAxis& axis = unit.axis(subject.id);
  const double from = command.letters[1] == 'O' ? std::round(axis.position()) : 0.0;
  const double position = from + command.numbers[0];
  if (unit.settings().limits) {
    if (position > axis.maximum()) {
      return Refuses("Maximum allowable " + subject.name + " position is " + Whole(axis.maximum()));
    }
    if (position < axis.minimum()) {
      return Refuses("Minimum allowable " + subject.name + " position is " + Whole(axis.minimum()));
    }
  } else if (std::abs(position) > kLargestCount) {
    return IllegalArgument();
  }
  unit.MoveTo(subject.id, position);
  return Done();
}

// A speed the axis can run at, or why it cannot.
PtuReply CheckSpeed(double magnitude, double lowest, double highest, const Subject& subject) {
  if (magnitude > highest) {
    return Refuses(subject.name + " speed cannot exceed " + Whole(highest) + " positions/sec");
  }
  if (magnitude < lowest) {
    return Refuses("Motor speed cannot be less than " + Whole(lowest) + " pos/sec");
  }
  return Done();
}

PtuReply SetSpeed(const PtuCommand& command, const Subject& subject, PtuUnit& unit) {
  const bool velocity_mode = unit.settings().velocity_mode;
  const PtuAxisSettings& settings = unit.axis_settings(subject.id);
  double speed = command.numbers[0];
  if (command.letters[1] == 'D') {
    const double now = unit.axis(subject.id).velocity();
    speed += std::round(velocity_mode ? now : std::abs(now));
  }
  if (!(velocity_mode && speed == 0.0)) {
    const double magnitude = velocity_mode ? std::abs(speed) : speed;
    PtuReply check = CheckSpeed(magnitude, settings.lower_speed, settings.upper_speed, subject);
    if (!check.ok) return check;
  }
  if (velocity_mode) {
    unit.RunAt(subject.id, speed);
  } else {
    unit.ChangeSpeed(subject.id, speed);
  }
  return Done();
}

// Settings that change the motor's speed tables: slow, and never in mid-motion.
PtuReply SetTable(const PtuCommand& command, const Subject& subject, PtuUnit& unit) {
  PtuAxisSettings& settings = unit.axis_settings(subject.id);
  const double value = command.numbers[0];
  PtuReply reply{true, "", PtuReply::When::kTables, unit.options().table_time_s};
  double* field = nullptr;
  PtuReply check;
  switch (command.letters[1]) {
    case 'A':
      field = &settings.acceleration;
      if (value < 1 || value > kFastestAcceleration) return IllegalArgument();
      break;
    case 'B':
      field = &settings.base_speed;
      if (value != 0.0 && value < kSlowestBaseSpeed) return IllegalArgument();
      if (value != 0.0) check = CheckSpeed(value, kSlowestBaseSpeed, settings.upper_speed, subject);
      break;
    case 'L':
      field = &settings.lower_speed;
      check = CheckSpeed(value, kSlowestSpeed, settings.upper_speed, subject);
      break;
    default:
      field = &settings.upper_speed;
      check = CheckSpeed(value, settings.lower_speed, unit.options().highest_upper_speed_counts_s,
                         subject);
      if (value > *field) reply.table_time_s = unit.options().upper_speed_time_s;
      break;
  }
  if (!check.ok) return check;
  if (*field == value) return Done();
  *field = value;
  settings.speed = std::clamp(settings.speed, settings.lower_speed, settings.upper_speed);
  settings.base_speed = std::min(settings.base_speed, settings.upper_speed);
  return reply;
}

PtuReply AxisQuery(const PtuCommand& command, const Subject& subject, PtuUnit& unit) {
  const PtuAxis& axis = unit.axis(subject.id);
  const PtuAxisSettings& settings = unit.axis_settings(subject.id);
  const bool velocity_mode = unit.settings().velocity_mode;
  const auto answer = [&](double value, const std::string& before, const std::string& after) {
    return Says(unit.verbose ? before + Whole(value) + after : Whole(value));
  };
  const std::string& name = subject.name;
  switch (command.letters[1]) {
    case 'P':
      return answer(axis.position(), "Current " + name + " position is ", "");
    case 'O':
      return answer(unit.Target(subject.id), "Target " + name + " position is ", "");
    case 'R': {
      char text[32];
      std::snprintf(text, sizeof text, "%.4f", unit.options().resolution_arcsec);
      return Says(unit.verbose ? text + (" seconds arc per " + name + " position") : text);
    }
    case 'N':
      return answer(axis.minimum(), "Minimum " + name + " position is ", "");
    case 'X':
      return answer(axis.maximum(), "Maximum " + name + " position is ", "");
    case 'S':
      return answer(velocity_mode ? unit.commanded_velocity(subject.id) : settings.speed,
                    "Target " + name + " speed is ", " positions/sec");
    case 'D':
      return answer(velocity_mode ? axis.velocity() : std::abs(axis.velocity()),
                    "Current " + name + " speed is ", " positions/sec");
    case 'A':
      return answer(settings.acceleration, name + " acceleration is ", " positions/sec^2");
    case 'B':
      return answer(settings.base_speed, "Current " + name + " base speed is ", " positions/sec");
    case 'U':
      return answer(settings.upper_speed, "Maximum " + name + " speed is ", " positions/sec");
    default:
      return answer(settings.lower_speed, "Minimum " + name + " speed is ", " positions/sec");
  }
}

PtuReply ExecuteAxis(const PtuCommand& command, PtuUnit& unit) {
  const Subject subject = SubjectOf(command);
  if (!command.has_number()) return AxisQuery(command, subject, unit);
  if (command.numbers.size() > 1) return IllegalArgument();
  switch (command.letters[1]) {
    case 'P':
    case 'O':
      return SetPosition(command, subject, unit);
    case 'S':
    case 'D':
      return SetSpeed(command, subject, unit);
    case 'A':
    case 'B':
    case 'L':
    case 'U':
      return SetTable(command, subject, unit);
    default:
      return IllegalArgument();
  }
}

// PH, PM, TH, TM: hold and move power of an axis.
PtuReply ExecutePower(const PtuCommand& command, PtuUnit& unit) {
  const Subject subject = SubjectOf(command);
  const bool holds = command.letters[1] == 'H';
  PtuAxisSettings& settings = unit.axis_settings(subject.id);
  char& mode = holds ? settings.hold_power : settings.move_power;
  if (command.letters.size() == 2) {
    const std::string word = mode == 'R'   ? "REGULAR"
                             : mode == 'L' ? "LOW"
                             : mode == 'H' ? "HIGH"
                                           : "OFF";
    return Says(unit.verbose ? subject.name + (holds ? " hold power is " : " move power is ") + word
                             : word);
  }
  const char wanted = command.letters[2];
  const std::string allowed = holds ? "RLO" : "HRL";
  if (command.letters.size() > 3 || allowed.find(wanted) == std::string::npos) {
    return IllegalCommand();
  }
  mode = wanted;
  return Done();
}

PtuReply ExecuteMonitor(const PtuCommand& command, PtuUnit& unit) {
  PtuSettings& settings = unit.settings();
  const auto& n = command.numbers;
  if (command.letters == "MQ") {
    std::string text = unit.verbose ? "Monitor scans " : "";
    for (const PtuAxisId id : kPtuAxes) {
      const auto i = static_cast<size_t>(id);
      text +=
          (i == 0 ? "" : ",") + Whole(settings.monitor_a[i]) + "," + Whole(settings.monitor_b[i]);
    }
    return Says(text);
  }
  if (command.letters != "M") {
    settings.monitor_at_power_up = command.letters == "ME";
    return Done();
  }
  if (settings.velocity_mode) return IllegalCommand();
  if (!n.empty() && n.size() != 2 && n.size() != 4) return IllegalArgument();
  for (size_t i = 0; i < n.size(); ++i) {
    const PtuAxis& axis = unit.axis(kPtuAxes[i / 2]);
    if (n[i] < axis.minimum() || n[i] > axis.maximum()) return IllegalArgument();
  }
  for (size_t axis = 0; axis < n.size() / 2; ++axis) {
    settings.monitor_a[axis] = n[2 * axis];
    settings.monitor_b[axis] = n[2 * axis + 1];
  }
  unit.StartMonitor();
  return Done();
}

// Modes with a query and a letter for each value; nothing when the letters are none of them.
std::optional<PtuReply> ExecuteModes(const std::string& letters, PtuUnit& unit) {
  PtuSettings& settings = unit.settings();
  if (letters == "I" || letters == "S") {
    settings.immediate = letters == "I";
    if (settings.immediate) unit.StartPendingMoves();
  } else if (letters == "L") {
    return Says(settings.limits ? "Limit bounds are ENABLED (soft limits enabled)"
                                : "Limit bounds are DISABLED");
  } else if (letters == "LE" || letters == "LD") {
    settings.limits = letters == "LE";
  } else if (letters == "E") {
    return Says(unit.echo ? "Echo mode is ENABLED" : "Echo mode is DISABLED");
  } else if (letters == "EE" || letters == "ED") {
    unit.echo = letters == "EE";
  } else if (letters == "F") {
    return Says(unit.verbose ? "ASCII VERBOSE mode" : "ASCII terse mode");
  } else if (letters == "FV" || letters == "FT") {
    unit.verbose = letters == "FV";
  } else if (letters == "C") {
    return Says(settings.velocity_mode ? "pure velocity control mode" : "independent control mode");
  } else if (letters == "CI" || letters == "CV") {
    unit.SetVelocityMode(letters == "CV");
  } else if (letters == "RE" || letters == "RD" || letters == "RP" || letters == "RT") {
    settings.reset_at_power_up = {letters == "RE" || letters == "RP",
                                  letters == "RE" || letters == "RT"};
  } else {
    return std::nullopt;
  }
  return Done();
}

std::optional<PtuReply> ExecuteActions(const std::string& letters, PtuUnit& unit) {
  if (letters == "A") {
    unit.StartPendingMoves();
    return PtuReply{true, "", PtuReply::When::kArrived, 0.0};
  }
  if (letters == "R") {
    unit.StartReset({true, true});
    return PtuReply{true, "", PtuReply::When::kReset, 0.0};
  }
  if (letters == "V") return Says(kVersion);
  if (letters == "O") return Says("Input 30 VDC @ 86 degF");
  if (letters == "?") return Says(kMenu);
  if (letters == "H" || letters == "HP" || letters == "HT") {
    if (letters != "HT") unit.Halt(PtuAxisId::kPan);
    if (letters != "HP") unit.Halt(PtuAxisId::kTilt);
    return Done();
  }
  if (letters == "DS") {
    unit.Save();
    return Done();
  }
  if (letters == "DR" || letters == "DF") {
    unit.Restore(letters == "DF");
    return Done();
  }
  return std::nullopt;
}

PtuReply ExecuteUnitId(const PtuCommand& command, PtuUnit& unit) {
  int& id = unit.settings().unit_id;
  if (!command.has_number()) {
    return Says(unit.verbose ? "Unit ID is " + std::to_string(id) : std::to_string(id));
  }
  if (command.numbers.size() > 1 || command.numbers[0] < 0 || command.numbers[0] > kLargestUnitId) {
    return IllegalArgument();
  }
  id = command.numbers[0];
  return Done();
}

}  // namespace

PtuReply ExecutePtuCommand(const PtuCommand& command, PtuUnit& unit) {
  const std::string& letters = command.letters;
  if (letters == "U") return ExecuteUnitId(command, unit);
  if (letters == "M" || letters == "ME" || letters == "MD" || letters == "MQ") {
    return ExecuteMonitor(command, unit);
  }
  if (letters[0] == 'P' || letters[0] == 'T') {
    const char second = letters.size() > 1 ? letters[1] : ' ';
    if (second == 'H' || second == 'M') {
      return command.has_number() ? IllegalArgument() : ExecutePower(command, unit);
    }
    const bool known = std::string("PORNXSDABUL").find(second) != std::string::npos;
    return letters.size() == 2 && known ? ExecuteAxis(command, unit) : IllegalCommand();
  }
  if (command.has_number()) return IllegalCommand();
  if (const auto reply = ExecuteModes(letters, unit)) return *reply;
  return ExecuteActions(letters, unit).value_or(IllegalCommand());
}

}  // namespace geon::sim
