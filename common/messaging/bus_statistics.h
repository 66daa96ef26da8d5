#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace geon::messaging {

// What one channel delivered to this process.
struct ChannelStatistics {
  int64_t received = 0;
  int64_t lost = 0;     // holes in seq
  int64_t refused = 0;  // did not decode
  int64_t bytes = 0;
  int32_t last_seq = 0;
};

// Counts messages, and lost ones by holes in seq: every channel has one publisher, which numbers
// its messages. A seq that does not grow is a publisher that started anew, not a loss.
// GEON_SESSION, which everybody publishes, is not judged.
class BusStatistics {
 public:
  // Returns how many messages were lost just before this one.
  int64_t CountReceived(std::string_view channel, int32_t seq, int64_t bytes);
  void CountRefused(std::string_view channel);

  const std::map<std::string, ChannelStatistics, std::less<>>& channels() const {
    return channels_;
  }
  int64_t received() const;
  int64_t lost() const;
  int64_t refused() const;

 private:
  ChannelStatistics& At(std::string_view channel);
  std::map<std::string, ChannelStatistics, std::less<>> channels_;
};

}  // namespace geon::messaging
