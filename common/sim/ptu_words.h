#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geon::sim {

// One word of the pan-tilt unit's command language: letters, then numbers. "pp-100" is PP with the
// one number -100; "M1,2,3,4" is M with four.
struct PtuCommand {
  std::string letters;       // upper case
  std::vector<int> numbers;  // separated by commas
  bool has_number() const { return !numbers.empty(); }
};

// Nothing for a word that is not a command: other characters, numbers that are none.
std::optional<PtuCommand> ParsePtuWord(std::string_view word);

}  // namespace geon::sim
