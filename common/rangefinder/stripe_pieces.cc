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

double DistanceOf(const PeakCandidate& a, const PeakCandidate& b) {
  return std::abs(a.fit.position_px - b.fit.position_px);
}

// Whether `next`, on a later line, may lie on the piece that `last` ends.
bool Continues(const PeakCandidate& last, const PeakCandidate& next, const PieceOptions& options) {
  const int lines_on = next.line - last.line;
  return lines_on <= options.max_gap_px + 1 && !next.too_wide &&
         DistanceOf(last, next) <= options.max_step_px * lines_on;
}

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

    // One spot, which goes on with the one piece there is: as nearly always.
    if (end - begin == 1 && open.size() == 1 &&
        Continues(candidates[pieces[open[0]].back()], candidates[begin], options)) {
      pieces[open[0]].push_back(begin);
      begin = end;
      continue;
    }

    still_open.clear();
    links.clear();
    for (const size_t piece : open) {
      const PeakCandidate& last = candidates[pieces[piece].back()];
      if (line - last.line > options.max_gap_px + 1) continue;
      still_open.push_back(piece);
      for (size_t k = begin; k < end; ++k) {
        if (Continues(last, candidates[k], options)) {
          links.push_back({DistanceOf(last, candidates[k]), piece, k});
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
