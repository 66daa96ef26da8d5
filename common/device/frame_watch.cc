#include "device/frame_watch.h"

#include <string_view>

namespace geon::device {

bool FrameWatch::IsFreshStamp(int64_t stamp) {
  if (stamp_ && stamp <= *stamp_) return false;
  stamp_ = stamp;
  return true;
}

bool FrameWatch::IsFreshContent(const std::vector<uint8_t>& pixels) {
  const std::string_view bytes(reinterpret_cast<const char*>(pixels.data()), pixels.size());
  const uint64_t hash = std::hash<std::string_view>{}(bytes);
  if (hash_ && hash == *hash_) return false;
  hash_ = hash;
  return true;
}

void FrameWatch::Reset() {
  stamp_.reset();
  hash_.reset();
}

}  // namespace geon::device
