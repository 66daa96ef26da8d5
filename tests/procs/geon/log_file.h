#pragma once

#include <lcm/eventlog.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "messaging/codec.h"

namespace geon::cli {

// Writes a log as lcm-logger does, for tests of what reads one.
class LogFile {
 public:
  explicit LogFile(const std::filesystem::path& file)
      : log_(lcm_eventlog_create(file.c_str(), "w")) {}
  ~LogFile() { lcm_eventlog_destroy(log_); }
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  // Each message a hundredth of a second after the one before.
  template <typename T>
  void Write(std::string_view channel, const T& value) {
    WriteBytes(channel, messaging::Encode(value));
  }
  void WriteBytes(std::string_view channel, std::vector<uint8_t> bytes) {
    std::string name(channel);
    lcm_eventlog_event_t event{};
    event.timestamp = utime_ += 10'000;
    event.channellen = static_cast<int32_t>(name.size());
    event.channel = name.data();
    event.datalen = static_cast<int32_t>(bytes.size());
    event.data = bytes.data();
    lcm_eventlog_write_event(log_, &event);
  }

 private:
  lcm_eventlog_t* log_;
  int64_t utime_ = 1'700'000'000'000'000;
};

}  // namespace geon::cli
