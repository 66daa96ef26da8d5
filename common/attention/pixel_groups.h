#pragma once

#include <vector>

#include "attention/bit_mask.h"

namespace geon::attention {

// Pixels [u_begin_px, u_end_px) of row v_px, all set; the pixels before and behind are not.
struct PixelRun {
  int v_px = 0;
  int u_begin_px = 0;
  int u_end_px = 0;
  int group = 0;
};

// The connected (8-neighbour) groups of a mask, as runs row by row from left to right. Groups are
// numbered from 0 in the order of their first runs.
//
// Source: blob analysis of thesis section 4.2.1; runs joined by union-find: Rosenfeld and Pfaltz
// (1966).
struct PixelGroups {
  std::vector<PixelRun> runs;
  int count = 0;
};
PixelGroups GroupPixels(const BitMask& mask);

}  // namespace geon::attention
