#pragma once

#include <cctype>
#include <map>
#include <string>

namespace geon::device {

// The least of a pan-tilt unit, after the manual, for tests of the driver: says what it is told to,
// moves at once, and can be spoilt in every way.
struct ScriptedPtu {
  bool alive = true;
  bool echo = true;
  bool verbose = true;
  bool reset_ends_with_line_end = true;
  bool moves = true;
  double silent_until_s = 0.0;
  double reset_time_s = 3.0;
  std::string before_next_reply;                 // glued to its front
  std::map<std::string, std::string> override_;  // full reply line by command
  std::map<std::string, int> values = {{"PP", 0},    {"TP", 0},   {"PN", -3090}, {"PX", 3090},
                                       {"TN", -907}, {"TX", 604}, {"PS", 1000},  {"TS", 1000},
                                       {"PL", 31},   {"TL", 31},  {"PU", 2902},  {"TU", 2902}};
  int resets = 0;
  int bad_commands = 0;

  // Off and on again: hunts silently, then greets with everything forgotten.
  void PowerCycle(double time_s) {
    echo = verbose = true;
    values["PP"] = values["TP"] = 0;
    silent_until_s = time_s + 2.0;
    greet_ = true;
  }

  std::string Step(double time_s, const std::string& heard) {
    if (!alive || time_s < silent_until_s) return {};
    std::string said;
    if (greet_) said += "\r\nPAN-TILT CONTROLLER v2.12\r\n";
    greet_ = false;
    if (pending_reset_ && time_s >= reset_done_s_) {
      pending_reset_ = false;
      said += reset_ends_with_line_end ? "!T!T!P!P*\r\n" : "!T!T!P!P*";
    }
    for (const char c : heard) {
      if (echo) said += c;
      if (c != ' ' && c != '\r') {
        command_ += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        continue;
      }
      const std::string command = std::exchange(command_, {});
      if (!command.empty()) said += Answer(command, time_s);
    }
    return said;
  }

 private:
  std::string Answer(const std::string& command, double time_s) {
    if (command == "R") {
      ++resets;
      pending_reset_ = true;
      reset_done_s_ = time_s + reset_time_s;
      return {};
    }
    const std::string front = std::exchange(before_next_reply, {});
    if (override_.contains(command)) return front + override_[command] + "\r\n";
    return front + Line(command) + "\r\n";
  }

  std::string Line(const std::string& command) {
    if (command == "ED") return echo = false, "*";
    if (command == "FT") return verbose = false, "* ASCII terse mode";
    if (command == "CI" || command == "I" || command == "LE") return "*";
    if (command == "V") return "* Pan-Tilt Controller v2.12.1d1(C14/E)";
    if (command == "PR" || command == "TR") return "* 185.1428";
    const std::string letters = command.substr(0, 2);
    if (!values.contains(letters)) return ++bad_commands, "! Illegal Command Entered";
    if (command.size() == 2) {
      return verbose ? "* Current value is " + std::to_string(values[letters])
                     : "* " + std::to_string(values[letters]);
    }
    const int value = std::stoi(command.substr(2));
    if (letters[1] == 'P' &&
        (value > values[{letters[0], 'X'}] || value < values[{letters[0], 'N'}])) {
      return ++bad_commands, "! Maximum allowable position";
    }
    if (moves || letters[1] != 'P') values[letters] = value;
    return "*";
  }

  bool greet_ = false;
  bool pending_reset_ = false;
  double reset_done_s_ = 0.0;
  std::string command_;
};

}  // namespace geon::device
