#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace geon::sim {

// A device at the end of a serial line: bytes in, bytes out, in virtual time that starts at 0 and
// never runs backwards. Bytes travel at the line's speed in both directions.
//
// Use: Receive what the host wrote, Advance to now, Transmit what has arrived at the host by now.
class SerialDevice {
 public:
  virtual ~SerialDevice() = default;

  // Bits per second, 8N1. A host at another speed reads and writes garbage.
  virtual int baud() const = 0;

  virtual void Receive(std::span<const uint8_t> bytes, double time_s) = 0;
  virtual void Advance(double time_s) = 0;
  virtual std::vector<uint8_t> Transmit(double time_s) = 0;

  // Switched off and on again: everything volatile is forgotten.
  virtual void PowerCycle(double time_s) = 0;
  // The host opened the port (its DTR line rose). Most devices do not notice.
  virtual void PortOpened(double /*time_s*/) {}
};

}  // namespace geon::sim
