#pragma once

#include <cstddef>
#include <vector>

#include "rangefinder/stripe_fit.h"

namespace geon::rangefinder {

// Source: ours; thesis section 3.1.1 assumes one unbroken stripe.
//
// A bright spot in one column (row) that may be the stripe.
struct PeakCandidate {
  int line = 0;           // the column (row)
  bool too_wide = false;  // glare: on no piece
  ProfileFit fit;
};

struct PieceOptions {
  int max_step_px = 3;
  int max_gap_px = 2;
  int min_piece_px = 6;
};

// Unbroken pieces of stripe: runs of candidates, each close to its neighbour's in the next column
// (row). Every candidate is on one piece at most; pieces shorter than min_piece_px are left out.
// Returns indices into `candidates`, which must be sorted by line.
std::vector<std::vector<size_t>> LinkPieces(const std::vector<PeakCandidate>& candidates,
                                            const PieceOptions& options);

}  // namespace geon::rangefinder
