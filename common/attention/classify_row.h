#pragma once

#include <cstdint>

#include "attention/color_tests.h"

namespace geon::attention {

// What the compiled model asks of a row of pixels. All pointers must outlive the call.
struct RowTests {
  const RegionTest* target = nullptr;
  int target_count = 0;
  const RegionTest* rim = nullptr;
  int rim_count = 0;
  int dark_level = 0;       // as in ColorModel
  int clipped_level = 256;  // as in ColorModel
  int lost_level = 255;     // pixels at or above are marked in RowBits::lost
};

// One bit a pixel, 64 pixels a word, the first pixel in the lowest bit. Without a rim (or levels)
// `rim` (or `cannot_tell`) is left as it is.
struct RowBits {
  uint64_t* target = nullptr;       // surely
  uint64_t* rim = nullptr;          // surely, whether target or not
  uint64_t* cannot_tell = nullptr;  // too dark or clipped, whether target or not
  uint64_t* lost = nullptr;
  uint64_t* doubt = nullptr;  // target or rim: ask the double-precision rule
};

// Classifies 64 * words pixels of three bytes. The same code for three kinds of processor: the
// caller must know that this one has the instructions (classify_pixels.h).
//
// Source: thesis 4.1.2; the arithmetic is PlaneTest's.
void ClassifyRowBaseline(const uint8_t* pixels, bool red_is_first, int words, const RowTests& tests,
                         const RowBits& bits);
void ClassifyRowAvx2(const uint8_t* pixels, bool red_is_first, int words, const RowTests& tests,
                     const RowBits& bits);
void ClassifyRowAvx512(const uint8_t* pixels, bool red_is_first, int words, const RowTests& tests,
                       const RowBits& bits);

}  // namespace geon::attention
