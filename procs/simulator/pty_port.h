#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"

namespace geon::simulator {

// The simulator's end of a serial line: a pseudo-terminal, raw on both ends, that a driver opens
// through a symbolic link which stays the same over restarts.
//
// What a driver does to a real line is felt here too: while nobody has it open, what is sent is
// lost; at another speed than `baud` every byte is garbled in both directions.
class PtyPort {
 public:
  // Puts `link` in place, replacing one left by an earlier run.
  static Result<PtyPort> Open(const std::filesystem::path& link, int baud);
  PtyPort(PtyPort&& other) noexcept;
  PtyPort& operator=(PtyPort&& other) noexcept;
  ~PtyPort();  // removes the link if it still is this port's

  struct Input {
    std::vector<uint8_t> bytes;
    bool opened = false;  // a driver has opened the port since the last call
  };
  // Never waits. A port that nobody has open gives nothing; it is asked again later.
  Input Read();
  // Never waits: what the line cannot take is lost, as on a wire.
  void Write(std::span<const uint8_t> bytes);

  bool is_open() const { return driver_present_; }
  // Speaks the driver's speed, or garbage.
  bool speed_matches() const;
  // Readable when a driver writes. While nobody has the port open it reports a hang-up all the
  // time: poll with a timer then, not with this.
  int file_descriptor() const { return master_; }
  const std::string& device() const { return device_; }

 private:
  PtyPort() = default;
  void UpdatePresence(bool* opened);
  void Close();

  int master_ = -1;
  int baud_ = 0;
  bool driver_present_ = false;
  std::string device_;
  std::filesystem::path link_;
};

}  // namespace geon::simulator
