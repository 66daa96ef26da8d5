#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace geon::device {

// The least of a Nomad 200, after its frame description, for tests of the driver: answers every
// command with a state packet, takes velocities at once, and can be spoilt in every way. Frames are
// put together by hand here, not by the codec under test.
struct ScriptedNomad {
  bool alive = true;
  bool hears_only = false;  // obeys, but its answers are lost
  bool masked = false;      // a mask has been set since power-up
  int timeout_s = 0;
  int sonar_rate = 0;
  int acceleration = 0;
  int velocity[3] = {0, 0, 0};
  int pose[4] = {0, 0, 0, 0};  // x, y, steer, turret
  uint32_t bumpers = 0;
  int sonar_in = 100;
  double booted_s = 0.0;
  std::string override_next;  // sent instead of the next answer
  std::vector<int> types;     // of the commands heard

  void PowerCycle(double time_s) {
    masked = false;
    timeout_s = sonar_rate = acceleration = 0;
    for (int& v : velocity) v = 0;
    for (int& p : pose) p = 0;
    booted_s = time_s;
    buffer_.clear();
  }

  std::string Step(double time_s, const std::string& heard) {
    if (!alive) return {};
    buffer_ += heard;
    std::string said;
    while (buffer_.size() >= 6) {
      const size_t size = static_cast<size_t>(Byte(1)) + 4;
      if (Byte(0) != 1 || buffer_.size() < size) break;
      said += Answer(time_s, size);
      buffer_.erase(0, size);
    }
    return hears_only ? std::string() : said;
  }

  static std::string Frame(int type, const std::string& payload) {
    std::string frame = {'\x01', static_cast<char>(payload.size() + 2), '\0',
                         static_cast<char>(type)};
    frame += payload;
    unsigned sum = 0;
    for (const char c : frame) sum += static_cast<uint8_t>(c);
    return frame + static_cast<char>(sum) + '\x5c';
  }

  std::string StatePayload(double time_s) const {
    std::string p(8, '\0');
    p += std::string(16, static_cast<char>(sonar_in));
    p += {static_cast<char>(bumpers >> 16), static_cast<char>(bumpers >> 8),
          static_cast<char>(bumpers)};
    for (const int value : pose) p += Signed(value);
    for (const int value : velocity) p += Signed(value);
    if (!masked) p += std::string(2, '\0');  // another length after power-up
    p += '\0';
    const auto ms = static_cast<uint32_t>((time_s - booted_s) * 1e3);
    for (unsigned shift = 0; shift < 32; shift += 8) p += static_cast<char>(ms >> shift);
    return p + std::string(2, '\xff');
  }

 private:
  int Byte(size_t i) const { return static_cast<uint8_t>(buffer_[i]); }
  int SignedAt(size_t i) const {
    const int magnitude = Byte(i) | (Byte(i + 1) & 0x7f) << 8;
    return Byte(i + 1) & 0x80 ? -magnitude : magnitude;
  }
  static std::string Signed(int value) {
    const int magnitude = value < 0 ? -value : value;
    return {static_cast<char>(magnitude & 0xff),
            static_cast<char>(magnitude >> 8 | (value < 0 ? 0x80 : 0))};
  }

  std::string Answer(double time_s, size_t size) {
    const int type = Byte(3);
    types.push_back(type);
    if (type == 1) acceleration = SignedAt(4);
    if (type == 5) {
      for (size_t i = 0; i < 3; ++i) velocity[i] = SignedAt(4 + 2 * i);
    }
    if (type == 6) masked = size == 13;
    if (type == 9) {
      for (int& v : velocity) v = 0;
    }
    if (type == 15) sonar_rate = Byte(4);
    if (type == 18) timeout_s = Byte(4);
    if (!override_next.empty()) return std::exchange(override_next, {});
    return Frame(type, StatePayload(time_s));
  }

  std::string buffer_;
};

}  // namespace geon::device
