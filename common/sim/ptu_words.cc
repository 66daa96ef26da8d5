#include "sim/ptu_words.h"

#include <charconv>

namespace geon::sim {

std::optional<PtuCommand> ParsePtuWord(std::string_view word) {
  PtuCommand command;
  size_t at = 0;
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || c == '_' || c == '?'; };
  for (; at < word.size(); ++at) {
    const char c = word[at];
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (!is_letter(upper)) break;
    command.letters.push_back(upper);
  }
  while (at < word.size()) {
    if (word[at] == '+') ++at;
    int number = 0;
    const char* const begin = word.data() + at;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error != std::errc()) return std::nullopt;
    command.numbers.push_back(number);
    at += static_cast<size_t>(stop - begin);
    if (at == word.size()) break;
    if (word[at] != ',' || at + 1 == word.size()) return std::nullopt;
    ++at;
  }
  if (command.letters.empty()) return std::nullopt;
  return command;
}

}  // namespace geon::sim
