#include "attention/bit_mask.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::attention {
namespace {

// Each pixel and its two neighbours in the row; `beyond` are the bits past the width.
void ErodeRow(const uint64_t* row, int words, uint64_t beyond, uint64_t* eroded) {
  uint64_t before = 1;  // the last pixel of the word before, in the lowest bit
  for (int word = 0; word < words; ++word) {
    const bool last = word + 1 == words;
    const uint64_t here = row[word] | (last ? beyond : 0);
    const uint64_t after = last ? 1 : row[word + 1] & 1;
    eroded[word] = here & (here << 1 | before) & (here >> 1 | after << 63);
    before = here >> 63;
  }
}

}  // namespace

BitMask::BitMask(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), words_((width_px + 63) / 64) {
  Require(width_px > 0 && height_px > 0, "BitMask: the size must be positive");
  bits_.assign(Offset(height_px), 0);
}

uint64_t BitMask::Within(int word) const {
  return word + 1 < words_ ? ~uint64_t{0} : ~uint64_t{0} >> (64 * words_ - width_px_);
}

void BitMask::Set(int v_px, int u_begin_px, int u_end_px) {
  uint64_t* bits = row(v_px);
  ForWords(u_begin_px, u_end_px, [bits](int word, uint64_t wanted) { bits[word] |= wanted; });
}

int BitMask::Count(int v_px, int u_begin_px, int u_end_px) const {
  const uint64_t* bits = row(v_px);
  int count = 0;
  ForWords(u_begin_px, u_end_px,
           [&](int word, uint64_t wanted) { count += CountBits(bits[word] & wanted); });
  return count;
}

int BitMask::Count() const {
  int count = 0;
  for (const uint64_t bits : bits_) count += CountBits(bits);
  return count;
}

bool BitMask::Any() const {
  return std::any_of(bits_.begin(), bits_.end(), [](uint64_t bits) { return bits != 0; });
}

BitMask Erode(const BitMask& mask, int neighbors) {
  Require(neighbors == 4 || neighbors == 8, "neighbors", neighbors, "must be 4 or 8");
  const int words = mask.words();
  const uint64_t beyond = ~mask.Within(words - 1);
  BitMask along(mask.width_px(), mask.height_px());
  for (int v = 0; v < mask.height_px(); ++v) ErodeRow(mask.row(v), words, beyond, along.row(v));
  BitMask eroded(mask.width_px(), mask.height_px());
  const BitMask& beside = neighbors == 8 ? along : mask;  // what rows above and below must hold
  for (int v = 0; v < mask.height_px(); ++v) {
    const uint64_t* here = along.row(v);
    const uint64_t* above = v > 0 ? beside.row(v - 1) : here;
    const uint64_t* below = v + 1 < mask.height_px() ? beside.row(v + 1) : here;
    for (int word = 0; word < words; ++word) {
      eroded.row(v)[word] = above[word] & here[word] & below[word] & mask.Within(word);
    }
  }
  return eroded;
}

}  // namespace geon::attention
