// Compiled once for every kind of processor (CMakeLists.txt); GEON_CLASSIFY_ROW is the name it
// gets.
#include "attention/classify_row.h"

#include <opencv2/core/simd_intrinsics.hpp>
#include <utility>

#ifndef GEON_CLASSIFY_ROW
#define GEON_CLASSIFY_ROW ClassifyRowBaseline
#endif

namespace geon::attention {
namespace {

using cv::v_int16;
using cv::v_uint8;

constexpr int kLanes = v_uint8::nlanes;
static_assert(64 % kLanes == 0);

uint64_t BitsOf(const v_uint8& mask) {
  const auto bits = cv::v_signmask(mask);
  return sizeof(bits) == 8 ? static_cast<uint64_t>(bits) : static_cast<uint32_t>(bits);
}

v_uint8 AtLeast(const v_uint8& level, uint8_t low) {
  return cv::v_max(level, cv::vx_setall_u8(low)) == level;
}
v_uint8 AtMost(const v_uint8& level, uint8_t high) {
  return cv::v_min(level, cv::vx_setall_u8(high)) == level;
}

// Some pixels' channels, as bytes and widened to 16 bits. To split them by even and odd places
// costs less than to keep their order.
struct Pixels {
  v_uint8 bytes[3];  // red, green, blue
  v_int16 even[3];
  v_int16 odd[3];
};

CV_ALWAYS_INLINE Pixels Load(const uint8_t* data, bool red_is_first) {
  Pixels pixels;
  cv::v_load_deinterleave(data, pixels.bytes[0], pixels.bytes[1], pixels.bytes[2]);
  if (!red_is_first) std::swap(pixels.bytes[0], pixels.bytes[2]);
  for (int channel = 0; channel < 3; ++channel) {
    const auto pairs = cv::v_reinterpret_as_u16(pixels.bytes[channel]);
    pixels.even[channel] = cv::v_reinterpret_as_s16(pairs & cv::vx_setall_u16(0xff));
    pixels.odd[channel] = cv::v_reinterpret_as_s16(pairs >> 8);
  }
  return pixels;
}

v_int16 Sum(const v_int16 (&channels)[3], const PlaneTest& plane) {
  const auto term = [&](int channel) {
    return cv::v_mul_wrap(channels[channel], cv::vx_setall_s16(plane.coefficients[channel]));
  };
  return cv::v_add_wrap(cv::v_add_wrap(term(0), term(1)), term(2));
}

v_uint8 Join(const v_int16& even, const v_int16& odd) {
  return cv::v_reinterpret_as_u8((even & cv::vx_setall_s16(0x00ff)) |
                                 (odd & cv::vx_setall_s16(static_cast<int16_t>(0xff00))));
}

struct Verdict {
  uint64_t sure = 0;
  uint64_t maybe = 0;  // holds the sure ones
};

// Two ways out early, for most pictures show little of the target; a way out behind every plane
// would cost more in wrong guesses of the processor than it saves.
CV_ALWAYS_INLINE Verdict InRegion(const Pixels& pixels, const RegionTest& region) {
  v_uint8 bounded = cv::vx_setall_u8(0xff);
  if (region.bounded) {
    for (int channel = 0; channel < 3; ++channel) {
      bounded = bounded & AtLeast(pixels.bytes[channel], region.low[channel]) &
                AtMost(pixels.bytes[channel], region.high[channel]);
    }
    if (!cv::v_check_any(bounded)) return {};
  }
  v_int16 even = cv::v_reinterpret_as_s16(bounded);  // of these, Join takes the bytes it should
  v_int16 odd = even;
  v_int16 sure_even = even;
  v_int16 sure_odd = even;
  for (size_t i = 0; i < region.planes.size(); ++i) {
    const PlaneTest& plane = region.planes[i];
    const v_int16 even_sum = Sum(pixels.even, plane);
    const v_int16 odd_sum = Sum(pixels.odd, plane);
    const v_int16 maybe = cv::vx_setall_s16(plane.maybe);
    even = even & (even_sum > maybe);
    odd = odd & (odd_sum > maybe);
    if (region.doubtful) {
      const v_int16 sure = cv::vx_setall_s16(plane.sure);
      sure_even = sure_even & (even_sum > sure);
      sure_odd = sure_odd & (odd_sum > sure);
    }
    if (i == 0 && region.planes.size() > 1 && !cv::v_check_any(Join(even, odd))) return {};
  }
  const uint64_t maybe = BitsOf(Join(even, odd));
  return {region.doubtful ? BitsOf(Join(sure_even, sure_odd)) : maybe, maybe};
}

CV_ALWAYS_INLINE Verdict InAny(const Pixels& pixels, const RegionTest* regions, int count) {
  Verdict any;
  for (int i = 0; i < count; ++i) {
    const Verdict verdict = InRegion(pixels, regions[i]);
    any.sure |= verdict.sure;
    any.maybe |= verdict.maybe;
  }
  return any;
}

v_uint8 Outside(const v_uint8& level, int dark_level, int clipped_level) {
  v_uint8 outside = cv::vx_setzero_u8();
  if (dark_level > 0) outside = AtMost(level, static_cast<uint8_t>(dark_level - 1));
  if (clipped_level < 256) outside = outside | AtLeast(level, static_cast<uint8_t>(clipped_level));
  return outside;
}

}  // namespace

void GEON_CLASSIFY_ROW(const uint8_t* data, bool red_is_first, int words, const RowTests& tests,
                       const RowBits& bits) {
  for (int word = 0; word < words; ++word) {
    Verdict target, rim;
    uint64_t cannot_tell = 0;
    uint64_t lost = 0;
    for (int place = 0; place < 64; place += kLanes, data += 3 * kLanes) {
      const Pixels pixels = Load(data, red_is_first);
      const v_uint8 largest =
          cv::v_max(pixels.bytes[0], cv::v_max(pixels.bytes[1], pixels.bytes[2]));
      const Verdict in_target = InAny(pixels, tests.target, tests.target_count);
      const Verdict in_rim = InAny(pixels, tests.rim, tests.rim_count);
      target.sure |= in_target.sure << place;
      target.maybe |= in_target.maybe << place;
      rim.sure |= in_rim.sure << place;
      rim.maybe |= in_rim.maybe << place;
      cannot_tell |= BitsOf(Outside(largest, tests.dark_level, tests.clipped_level)) << place;
      lost |= BitsOf(Outside(largest, 0, tests.lost_level)) << place;
    }
    bits.target[word] = target.sure;
    bits.rim[word] = rim.sure;
    bits.cannot_tell[word] = cannot_tell;
    bits.lost[word] = lost;
    bits.doubt[word] = (target.maybe & ~target.sure) | (rim.maybe & ~rim.sure);
  }
  cv::vx_cleanup();
}

}  // namespace geon::attention
