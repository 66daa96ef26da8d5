#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace geon::sim {

// What one line asks of the board; absent words are absent.
struct HorusBlock {
  bool moves = false;         // G1, or an X under it
  bool sets_zero = false;     // G50
  std::optional<int> m_code;  // 17, 18, 50, 70, 71
  std::optional<double> feed_deg_s;
  std::optional<double> x_deg;
  int tool = 0;  // T: which laser or sensor, as M50, M70 and M71 mean it
};

// Reads a line of G-code as the firmware does (upper case, no blanks). Returns its verdict: "ok" or
// the text that follows "error: ". `motion_is_modal`: a G1 has been heard, so that a lone X moves.
std::string ParseHorusBlock(std::string_view line, bool motion_is_modal, HorusBlock* block);

}  // namespace geon::sim
