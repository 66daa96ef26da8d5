#include "rangefinder/stripe_pieces.h"

#include <algorithm>
#include <cmath>

namespace geon::rangefinder {
namespace {

struct Link {
  double distance_px = 0.0;
  size_t piece = 0;
  size_t candidate = 0;
};

}  // namespace

std::vector<std::vector<size_t>> LinkPieces(const std::vector<PeakCandidate>& candidates,
                                            const PieceOptions& options) {
  std::vector<std::vector<size_t>> pieces;
  std::vector<size_t> open;  // pieces that the present line may still continue
  std::vector<size_t> still_open;
  std::vector<Link> links;
  std::vector<bool> taken;
  size_t begin = 0;
  while (begin < candidates.size()) {
    const int line = candidates[begin].line;
    size_t end = begin;
    while (end < candidates.size() && candidates[end].line == line) ++end;

    still_open.clear();
    links.clear();
    for (const size_t piece : open) {
      const PeakCandidate& last = candidates[pieces[piece].back()];
      const int lines_on = line - last.line;
      if (lines_on > options.max_gap_px + 1) continue;
      still_open.push_back(piece);
      for (size_t k = begin; k < end; ++k) {
        if (candidates[k].too_wide) continue;
        const double distance_px = std::abs(candidates[k].fit.position_px - last.fit.position_px);
        if (distance_px <= static_cast<double>(options.max_step_px * lines_on)) {
          links.push_back({distance_px, piece, k});
        }
      }
    }
    std::swap(open, still_open);

    // Nearest first, one to one.
    if (links.size() > 1) {
      std::stable_sort(links.begin(), links.end(),
                       [](const Link& a, const Link& b) { return a.distance_px < b.distance_px; });
    }
    taken.assign(end - begin, false);
    for (const Link& link : links) {
      const bool piece_is_taken = candidates[pieces[link.piece].back()].line == line;
      if (piece_is_taken || taken[link.candidate - begin]) continue;
      pieces[link.piece].push_back(link.candidate);
      taken[link.candidate - begin] = true;
    }
    for (size_t k = begin; k < end; ++k) {
      if (taken[k - begin] || candidates[k].too_wide) continue;
      open.push_back(pieces.size());
      pieces.push_back({k});
    }
    begin = end;
  }
  std::erase_if(pieces, [&](const std::vector<size_t>& piece) {
    return static_cast<int>(piece.size()) < options.min_piece_px;
  });
  return pieces;
}

}  // namespace geon::rangefinder
