#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "device/back_off.h"
#include "device/serial_port.h"

namespace geon::device {

struct SerialLinkOptions {
  std::string path;
  int baud = 9600;
  double first_retry_s = 0.2;  // wait before the first attempt to reopen; doubles up to
  double longest_retry_s = 2.0;
};

// Keeps one serial device open: notices that it went (unplugged, daemon behind a pty died), reopens
// it under the same path with back-off and counts how often. Times are of one monotonic clock.
class SerialLink {
 public:
  struct Traffic {
    bool opened = false;  // the device was (re)opened in this call
    bool lost = false;    // the device went in this call
    std::string bytes;    // what arrived
  };

  explicit SerialLink(const SerialLinkOptions& options);

  // Opens when due, sends what is left over, receives.
  Traffic Service(double time_s);
  // Bytes for a device that is not there are dropped: the driver starts over after reopening.
  void Send(std::string_view bytes);
  // Waits for bytes at most this long; returns at once without a device.
  void WaitReadable(double timeout_s) const;

  bool is_open() const { return port_.has_value(); }
  int reconnects() const { return reconnects_; }           // times it was opened again
  const std::string& trouble() const { return trouble_; }  // why it is not open; empty when it is

 private:
  void Lose(const Status& status);

  SerialLinkOptions options_;
  std::optional<SerialPort> port_;
  std::string unsent_;
  std::string trouble_;
  BackOff retry_;
  bool lost_ = false;
  bool ever_open_ = false;
  int reconnects_ = 0;
};

// One turn of a driver (PtuDriver, NomadDriver, LaserDriver) on its line.
template <typename Driver>
void Pump(SerialLink* link, Driver* driver, double time_s) {
  const SerialLink::Traffic traffic = link->Service(time_s);
  if (traffic.lost) driver->Disconnected(time_s);
  if (traffic.opened) driver->Connected(time_s);
  link->Send(driver->Step(time_s, traffic.bytes));
}

}  // namespace geon::device
