#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geon::attention {

// How many bits are 1. Without an instruction for it std::popcount is a call and a table, which is
// dear where a picture has a hundred thousand runs.
constexpr int CountBits(uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555;  // of every two, then four, then eight
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>(bits * 0x0101010101010101 >> 56);
}

// Calls use(word, bits) for the words that hold pixels [begin, end) of a row, begin < end.
template <typename Use>
void ForWords(int begin_px, int end_px, const Use& use) {
  const int last = (end_px - 1) / 64;
  uint64_t bits = ~uint64_t{0} << (begin_px % 64);
  for (int word = begin_px / 64; word < last; ++word) {
    use(word, bits);
    bits = ~uint64_t{0};
  }
  use(last, bits & ~uint64_t{0} >> (63 - (end_px - 1) % 64));
}

// A yes or no for every pixel of an image, 64 pixels a word: pixel u of a row is bit u % 64 of word
// u / 64. Bits beyond the width are 0.
//
// Source: own; binary images of thesis section 4.1.2, erosion of 4.2.1.
class BitMask {
 public:
  BitMask(int width_px, int height_px);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  int words() const { return words_; }  // of a row

  uint64_t* row(int v_px) { return bits_.data() + Offset(v_px); }
  const uint64_t* row(int v_px) const { return bits_.data() + Offset(v_px); }
  // The bits of word `word` that lie within the width.
  uint64_t Within(int word) const;

  bool At(int u_px, int v_px) const { return (row(v_px)[u_px / 64] >> (u_px % 64) & 1) != 0; }
  // Pixels [u_begin, u_end) of a row, u_begin < u_end.
  void Set(int v_px, int u_begin_px, int u_end_px);
  int Count(int v_px, int u_begin_px, int u_end_px) const;
  int Count() const;
  bool Any() const;

  friend bool operator==(const BitMask&, const BitMask&) = default;

 private:
  size_t Offset(int v_px) const { return static_cast<size_t>(v_px) * static_cast<size_t>(words_); }

  int width_px_;
  int height_px_;
  int words_;
  std::vector<uint64_t> bits_;
};

// The pixels all of whose 8 (or 4) neighbours are set too. Beyond the border counts as set.
BitMask Erode(const BitMask& mask, int neighbors);

}  // namespace geon::attention
