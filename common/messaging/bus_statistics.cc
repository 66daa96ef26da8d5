#include "messaging/bus_statistics.h"

#include "messaging/channels.h"

namespace geon::messaging {
namespace {

// A larger step is another publisher, or nonsense.
constexpr int64_t kLongestHole = 1'000'000;

}  // namespace

ChannelStatistics& BusStatistics::At(std::string_view channel) {
  const auto it = channels_.find(channel);
  if (it != channels_.end()) return it->second;
  return channels_[std::string(channel)];
}

int64_t BusStatistics::CountReceived(std::string_view channel, int32_t seq, int64_t bytes) {
  ChannelStatistics& statistics = At(channel);
  int64_t lost = 0;
  const int64_t step = static_cast<int64_t>(seq) - statistics.last_seq;
  if (statistics.received > 0 && step > 1 && step < kLongestHole && channel != kGeonSession)
    lost = step - 1;
  statistics.received += 1;
  statistics.bytes += bytes;
  statistics.lost += lost;
  statistics.last_seq = seq;
  return lost;
}

void BusStatistics::CountRefused(std::string_view channel) { At(channel).refused += 1; }

int64_t BusStatistics::received() const {
  int64_t sum = 0;
  for (const auto& [name, statistics] : channels_) sum += statistics.received;
  return sum;
}

int64_t BusStatistics::lost() const {
  int64_t sum = 0;
  for (const auto& [name, statistics] : channels_) sum += statistics.lost;
  return sum;
}

int64_t BusStatistics::refused() const {
  int64_t sum = 0;
  for (const auto& [name, statistics] : channels_) sum += statistics.refused;
  return sum;
}

}  // namespace geon::messaging
