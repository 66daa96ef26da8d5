#include "sim/horus_gcode.h"

#include <cmath>

namespace geon::sim {
namespace {

// The firmware's own number reader: sign, digits, one point; no exponent.
std::optional<double> ReadNumber(std::string_view line, size_t* at) {
  size_t i = *at;
  double sign = 1.0;
  if (i < line.size() && (line[i] == '-' || line[i] == '+')) sign = line[i++] == '-' ? -1.0 : 1.0;
  double value = 0.0;
  double scale = 1.0;
  int digits = 0;
  bool fraction = false;
  for (; i < line.size(); ++i) {
    if (line[i] == '.' && !fraction) {
      fraction = true;
    } else if (line[i] >= '0' && line[i] <= '9') {
      value = 10.0 * value + (line[i] - '0');
      if (fraction) scale *= 10.0;
      ++digits;
    } else {
      break;
    }
  }
  if (digits == 0) return std::nullopt;
  *at = i;
  return sign * value / scale;
}

std::string TakeGWord(int code, HorusBlock* block) {
  if (code != 1 && code != 50) return "Unsupported command";
  if (block->moves || block->sets_zero) return "Modal group violation";
  (code == 1 ? block->moves : block->sets_zero) = true;
  return "ok";
}

std::string TakeMWord(int code, HorusBlock* block) {
  const bool known = code == 17 || code == 18 || code == 50 || code == 70 || code == 71;
  if (!known) return "Unsupported command";
  if (block->m_code) return "Modal group violation";
  block->m_code = code;
  return "ok";
}

}  // namespace

std::string ParseHorusBlock(std::string_view line, bool motion_is_modal, HorusBlock* block) {
  *block = {};
  bool has_tool = false;
  for (size_t at = 0; at < line.size();) {
    const char letter = line[at++];
    if (letter < 'A' || letter > 'Z') return "Expected command letter";
    const std::optional<double> number = ReadNumber(line, &at);
    if (!number) return "Bad number format";
    std::string verdict = "ok";
    if (letter == 'G' || letter == 'M') {
      if (std::abs(*number) > 255.0) return "Unsupported command";
      if (*number != std::trunc(*number)) return "Invalid gcode ID:23";
      const int code = static_cast<int>(*number);
      verdict = letter == 'G' ? TakeGWord(code, block) : TakeMWord(code, block);
    } else if (letter == 'F') {
      if (*number < 0.0) return "Value < 0";
      if (block->feed_deg_s) return "Invalid gcode ID:25";
      block->feed_deg_s = *number;
    } else if (letter == 'X') {
      if (block->x_deg) return "Invalid gcode ID:25";
      block->x_deg = *number;
    } else if (letter == 'T') {
      if (*number < 0.0) return "Value < 0";
      if (has_tool) return "Invalid gcode ID:25";
      has_tool = true;
      block->tool = *number > 255.0 ? 255 : static_cast<int>(*number);
    } else {
      return "Unsupported command";
    }
    if (verdict != "ok") return verdict;
  }
  if (block->x_deg && !block->moves) {
    if (!motion_is_modal || block->sets_zero) return "Invalid statement";
    block->moves = true;
  }
  return "ok";
}

}  // namespace geon::sim
