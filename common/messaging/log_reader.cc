#include "messaging/log_reader.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace geon::messaging {
namespace {

constexpr uint32_t kSyncWord = 0xEDA1DA01;
constexpr size_t kHeaderSize = 28;  // sync 4, number 8, utime 8, channel length 4, data length 4
constexpr int64_t kLongestChannel = 63;
constexpr int64_t kLongestData = 64 << 20;

uint64_t BigEndianAt(const uint8_t* bytes, size_t size) {
  uint64_t bits = 0;
  for (size_t i = 0; i < size; ++i) bits = bits << 8 | bytes[i];
  return bits;
}

}  // namespace

Result<LogReader> LogReader::Open(const std::filesystem::path& file) {
  std::FILE* stream = std::fopen(file.c_str(), "rb");
  if (stream == nullptr) return Status::Error(file.string() + ": " + std::strerror(errno));
  struct stat info {};
  if (fstat(fileno(stream), &info) != 0 || !S_ISREG(info.st_mode)) {
    std::fclose(stream);
    return Status::Error(file.string() + ": not a file");
  }
  return LogReader(stream, info.st_size);
}

std::optional<LogEvent> LogReader::Next() {
  while (position_ < size_) {
    int64_t end = 0;
    if (std::optional<LogEvent> event = EventAt(position_, &end)) {
      if (event->number > last_number_ + 1 && last_number_ >= 0) {
        damage_.missing_events += event->number - last_number_ - 1;
      }
      last_number_ = event->number;
      position_ = end;
      return event;
    }
    const int64_t next = FindSync(position_ + 1);
    // An event that begins well and has no end because the file ends: the logger was cut off.
    const bool torn = next >= size_ && StartsEvent(position_);
    if (torn) {
      damage_.torn_tail_bytes = size_ - position_;
    } else {
      damage_.skipped_bytes += next - position_;
      damage_.damaged_places += 1;
    }
    position_ = next;
  }
  return std::nullopt;
}

void LogReader::Rewind() {
  position_ = 0;
  last_number_ = -1;
  damage_ = {};
}

bool LogReader::ReadAt(int64_t position, void* to, size_t count) {
  if (std::ftell(file_.get()) != position && std::fseek(file_.get(), position, SEEK_SET) != 0) {
    return false;
  }
  return std::fread(to, 1, count, file_.get()) == count;
}

std::optional<LogEvent> LogReader::EventAt(int64_t position, int64_t* end) {
  std::array<uint8_t, kHeaderSize> header{};
  if (!ReadAt(position, header.data(), header.size())) return std::nullopt;
  if (BigEndianAt(header.data(), 4) != kSyncWord) return std::nullopt;
  const auto channel_size = static_cast<int32_t>(BigEndianAt(&header[20], 4));
  const auto data_size = static_cast<int32_t>(BigEndianAt(&header[24], 4));
  if (channel_size < 1 || channel_size > kLongestChannel) return std::nullopt;
  if (data_size < 0 || data_size > kLongestData) return std::nullopt;
  *end = position + static_cast<int64_t>(kHeaderSize) + channel_size + data_size;
  if (*end > size_) return std::nullopt;

  LogEvent event;
  event.number = static_cast<int64_t>(BigEndianAt(&header[4], 8));
  event.utime = static_cast<int64_t>(BigEndianAt(&header[12], 8));
  event.channel.resize(static_cast<size_t>(channel_size));
  event.bytes.resize(static_cast<size_t>(data_size));
  if (!ReadAt(position + static_cast<int64_t>(kHeaderSize), event.channel.data(),
              event.channel.size()) ||
      !ReadAt(*end - data_size, event.bytes.data(), event.bytes.size())) {
    return std::nullopt;
  }
  // Where no event follows, a length may be wrong: a sync word inside would be another event's.
  if (*end < size_ && !StartsEvent(*end) && FindSync(position + 1) < *end) return std::nullopt;
  return event;
}

bool LogReader::StartsEvent(int64_t position) {
  std::array<uint8_t, 4> sync{};
  const auto count = std::min<size_t>(sync.size(), static_cast<size_t>(size_ - position));
  constexpr std::array<uint8_t, 4> kSyncBytes = {0xED, 0xA1, 0xDA, 0x01};
  return ReadAt(position, sync.data(), count) &&
         std::equal(sync.begin(), sync.begin() + static_cast<ptrdiff_t>(count), kSyncBytes.begin());
}

// First position from `position` on where a sync word stands; the end of the file when there is
// none.
int64_t LogReader::FindSync(int64_t position) {
  std::array<uint8_t, 65536> block{};
  while (position + 4 <= size_) {
    const auto count = std::min<size_t>(block.size(), static_cast<size_t>(size_ - position));
    if (!ReadAt(position, block.data(), count)) return size_;
    for (size_t i = 0; i + 4 <= count; ++i) {
      if (BigEndianAt(&block[i], 4) == kSyncWord) return position + static_cast<int64_t>(i);
    }
    position += static_cast<int64_t>(count) - 3;
  }
  return size_;
}

std::string Describe(const LogDamage& damage) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (damage.skipped_bytes > 0) {
    add("skipped " + std::to_string(damage.skipped_bytes) + " damaged bytes in " +
        std::to_string(damage.damaged_places) + " place(s)");
  }
  if (damage.missing_events > 0) {
    add(std::to_string(damage.missing_events) + " event(s) missing by number");
  }
  if (damage.torn_tail_bytes > 0) {
    add("the last event is torn (" + std::to_string(damage.torn_tail_bytes) +
        " bytes): the logger was cut off");
  }
  return text.empty() ? "whole" : text;
}

}  // namespace geon::messaging
