#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace geon::device {

// Tells fresh frames from a camera's repetitions: a driver whose device is gone may deliver its
// last frame for ever. Fresh is a stamp that grows; where the source has no stamps of its own,
// content that differs.
class FrameWatch {
 public:
  bool IsFreshStamp(int64_t stamp);
  bool IsFreshContent(const std::vector<uint8_t>& pixels);
  void Reset();

 private:
  std::optional<int64_t> stamp_;
  std::optional<uint64_t> hash_;
};

}  // namespace geon::device
