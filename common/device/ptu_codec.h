#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace geon::device {

// Source: Directed Perception PTU-D46 manual, ASCII command set. A command is letters, an optional
// number and a delimiter (we send a space). The answer is one line, "* [result]" or "! message".
// The unit may put "!P" or "!T" (a limit was hit: the axis lost its reference) anywhere in between,
// and after power-up it echoes commands and answers in sentences until told ED and FT.

std::string EncodePtuCommand(std::string_view letters);
std::string EncodePtuCommand(std::string_view letters, int value);

struct PtuLine {
  enum class Kind {
    kDone,     // "*"
    kRefused,  // "! message"
    kBanner,   // start-up text of the unit
    kUnknown,  // no "*" and no "!": noise, or the menu
  };
  Kind kind = Kind::kUnknown;
  std::string echo;  // what stood before "*" or "!"
  std::string text;  // what stood after it; the whole line for the other kinds
};

// Cuts bytes into lines (CR, LF or both; blank ones are skipped), takes the limit marks out
// wherever they are and counts them.
class PtuReader {
 public:
  void Push(std::string_view bytes);
  std::optional<PtuLine> Next();
  // The line begun but not ended: some firmware ends the answer to R without a line end.
  std::optional<PtuLine> TakeUnfinished();
  // Limit marks since last asked.
  bool TakePanLimit();
  bool TakeTiltLimit();
  void Clear();

 private:
  void PushByte(char byte);

  std::string buffer_;
  bool mark_begun_ = false;  // the last byte was a "!" that may begin a mark
  bool pan_limit_ = false;
  bool tilt_limit_ = false;
};

// The whole text as one number, as terse mode prints it; nothing for anything else (verbose
// sentences, noise, no text at all: a missing number is never zero).
std::optional<double> ParsePtuNumber(std::string_view text);
std::optional<int> ParsePtuCount(std::string_view text);

}  // namespace geon::device
