#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace geon::device {

// Source: firmware of the Horus/Ciclop board (G-code over 115200 8N1): M71T<n> switches laser n on,
// M70T<n> off, one command a line; each command is answered by "ok" or "error: <text>". The board
// says "Horus 0.2 ['$' for help]" when it (re)starts, with all lasers off.

// A line that says "off" ("on") for laser 1 or 2. The board answers "ok" to numbers it does not
// have.
std::string EncodeLaserOff(int number);
std::string EncodeLaserOn(int number);
// Ctrl-X: restarts the firmware, whatever it is doing.
std::string EncodeHorusReset();

struct HorusLine {
  enum class Kind {
    kOk,
    kError,          // "error: <text>" or "ALARM: <text>"
    kBanner,         // of a firmware whose protocol this is: "Horus 0.2..."
    kForeignBanner,  // of another firmware version
    kNote,           // "[...]" and "<...>": feedback nobody asked for, harmless
    kUnknown,        // noise
  };
  Kind kind = Kind::kUnknown;
  std::string text;
};

// Cuts bytes into lines (CR, LF or both; blank lines are skipped) and sorts them. Lines beyond any
// length the board sends are noise.
class HorusReader {
 public:
  void Push(std::string_view bytes) { buffer_ += bytes; }
  std::optional<HorusLine> Next();
  void Clear() { buffer_.clear(); }

 private:
  std::string buffer_;
};

}  // namespace geon::device
