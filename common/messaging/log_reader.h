#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "messaging/codec.h"

namespace geon::messaging {

// One recorded message. Decode<sensor::Stripe>(event.bytes) gives what was said.
struct LogEvent {
  int64_t number = 0;  // as the logger counted
  int64_t utime = 0;   // when the logger received it
  std::string channel;
  std::vector<uint8_t> bytes;
};

// What was wrong with a log, as far as it has been read.
struct LogDamage {
  int64_t skipped_bytes = 0;    // passed over to find the next whole event
  int64_t damaged_places = 0;   // runs of such bytes
  int64_t missing_events = 0;   // holes in the event numbers
  int64_t torn_tail_bytes = 0;  // the last event was not written to its end
  bool any() const { return skipped_bytes > 0 || missing_events > 0 || torn_tail_bytes > 0; }
};

// Reads an LCM log event by event (sync word 0xEDA1DA01, number, utime, lengths, channel, data, all
// big-endian) and goes on after damage: where an event's header or its end is not what it must be,
// it searches the next sync word from the byte after the bad one. LCM's own reader trusts the
// lengths and loses what follows (44 of 87 events in one measured log).
//
//   Result<LogReader> log = LogReader::Open(file);
//   while (std::optional<LogEvent> event = log->Next()) ...
//   if (log->damage().any()) ...
class LogReader {
 public:
  static Result<LogReader> Open(const std::filesystem::path& file);

  // The next whole event in file order; nothing at the end.
  std::optional<LogEvent> Next();
  // From the first event again.
  void Rewind();
  const LogDamage& damage() const { return damage_; }
  int64_t file_bytes() const { return size_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  explicit LogReader(std::FILE* file, int64_t size) : file_(file), size_(size) {}
  bool ReadAt(int64_t position, void* to, size_t count);
  std::optional<LogEvent> EventAt(int64_t position, int64_t* end);
  bool StartsEvent(int64_t position);
  int64_t FindSync(int64_t position);

  std::unique_ptr<std::FILE, Close> file_;
  int64_t size_ = 0;
  int64_t position_ = 0;
  int64_t last_number_ = -1;
  LogDamage damage_;
};

// The text of a damage for people: "skipped 1234 bytes in 2 places, ...".
std::string Describe(const LogDamage& damage);

}  // namespace geon::messaging
