// Compiled once for every kind of processor (CMakeLists.txt); GEON_CLASSIFY_ROW is the name it
// gets.
#include "attention/classify_row.h"

#include <bit>
#include <cstring>
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

// The channels red, green, blue of some pixels.
struct Pixels {
  v_uint8 bytes[3];
};

CV_ALWAYS_INLINE Pixels Load(const uint8_t* data, bool red_is_first) {
  Pixels pixels;
  cv::v_load_deinterleave(data, pixels.bytes[0], pixels.bytes[1], pixels.bytes[2]);
  if (!red_is_first) std::swap(pixels.bytes[0], pixels.bytes[2]);
  return pixels;
}

// Bytes widened to 16 bits: those at even and at odd places, which costs less than their order.
v_int16 EvenOf(const v_uint8& bytes) {
  return cv::v_reinterpret_as_s16(cv::v_reinterpret_as_u16(bytes) & cv::vx_setall_u16(0xff));
}
v_int16 OddOf(const v_uint8& bytes) {
  return cv::v_reinterpret_as_s16(cv::v_reinterpret_as_u16(bytes) >> 8);
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
  const v_int16 even_channels[3] = {EvenOf(pixels.bytes[0]), EvenOf(pixels.bytes[1]),
                                    EvenOf(pixels.bytes[2])};
  const v_int16 odd_channels[3] = {OddOf(pixels.bytes[0]), OddOf(pixels.bytes[1]),
                                   OddOf(pixels.bytes[2])};
  v_int16 even = cv::v_reinterpret_as_s16(bounded);  // of these, Join takes the bytes it should
  v_int16 odd = even;
  v_int16 sure_even = even;
  v_int16 sure_odd = even;
  for (size_t i = 0; i < region.planes.size(); ++i) {
    const PlaneTest& plane = region.planes[i];
    const v_int16 even_sum = Sum(even_channels, plane);
    const v_int16 odd_sum = Sum(odd_channels, plane);
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

// The bits of the block-th kLanes pixels of a row.
void Store(uint64_t block_bits, int block, uint64_t* row) {
  static_assert(std::endian::native == std::endian::little);
  std::memcpy(reinterpret_cast<uint8_t*>(row) + block * (kLanes / 8), &block_bits, kLanes / 8);
}

}  // namespace

void GEON_CLASSIFY_ROW(const uint8_t* data, bool red_is_first, int words, const RowTests& row_tests,
                       const RowBits& row_bits) {
  // Copies: stores of bytes may change whatever a reference refers to, and it would be read again.
  const RowTests tests = row_tests;
  const RowBits bits = row_bits;
  const v_uint8 lost_level = cv::vx_setall_u8(static_cast<uint8_t>(tests.lost_level));
  const bool has_levels = tests.dark_level > 0 || tests.clipped_level < 256;
  const int blocks = words * (64 / kLanes);
  for (int block = 0; block < blocks; ++block, data += 3 * kLanes) {
    const Pixels pixels = Load(data, red_is_first);
    const v_uint8 largest = cv::v_max(pixels.bytes[0], cv::v_max(pixels.bytes[1], pixels.bytes[2]));
    const Verdict target = InAny(pixels, tests.target, tests.target_count);
    Store(target.sure, block, bits.target);
    uint64_t doubt = target.maybe & ~target.sure;
    if (tests.rim_count > 0) {
      const Verdict rim = InAny(pixels, tests.rim, tests.rim_count);
      Store(rim.sure, block, bits.rim);
      doubt |= rim.maybe & ~rim.sure;
    }
    Store(doubt, block, bits.doubt);
    if (has_levels) {
      Store(BitsOf(Outside(largest, tests.dark_level, tests.clipped_level)), block,
            bits.cannot_tell);
    }
    Store(BitsOf(cv::v_max(largest, lost_level) == largest), block, bits.lost);
  }
  cv::vx_cleanup();
}

}  // namespace geon::attention
