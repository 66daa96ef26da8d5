#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace geon::device {

// One open serial device: raw 8N1 without handshake, non-blocking, exclusive (TIOCEXCL), never the
// controlling terminal. Closes itself. An error of Read or Write means that the device is gone.
class SerialPort {
 public:
  // `baud` is one of the POSIX rates (4800 ... 230400). Discards what was received before.
  static Result<SerialPort> Open(const std::string& path, int baud);

  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  ~SerialPort();

  // What has arrived, possibly nothing.
  Result<std::string> Read();
  // Hands over as much as the kernel takes at once; returns how many bytes that were.
  Result<size_t> Write(std::string_view bytes);
  // Waits until bytes arrive or the time is over.
  void WaitReadable(double timeout_s) const;

  int file_descriptor() const { return file_descriptor_; }
  const std::string& path() const { return path_; }

 private:
  SerialPort(int file_descriptor, std::string path);
  int file_descriptor_ = -1;
  std::string path_;
};

}  // namespace geon::device
