#include "attention/pixel_groups.h"

#include <bit>
#include <utility>

namespace geon::attention {
namespace {

// Appends the runs of one row, each in a group of its own: the run's index.
void AppendRuns(const uint64_t* bits, int words, int v, std::vector<PixelRun>* runs) {
  int begin = -1;  // of the run that reaches the end of the word before
  for (int word = 0; word < words; ++word) {
    const int base = 64 * word;
    uint64_t rest = bits[word];
    if (begin >= 0) {
      if (rest == ~uint64_t{0}) continue;
      const int end = std::countr_one(rest);
      runs->push_back({v, begin, base + end, static_cast<int>(runs->size())});
      begin = -1;
      rest &= rest + 1;  // without the ones at the low end
    }
    while (rest != 0) {
      const int first = std::countr_zero(rest);
      const int length = std::countr_one(rest >> first);
      if (first + length == 64) {
        begin = base + first;
        break;
      }
      runs->push_back({v, base + first, base + first + length, static_cast<int>(runs->size())});
      rest &= rest + (uint64_t{1} << first);  // carries through the run's ones
    }
  }
  if (begin >= 0) runs->push_back({v, begin, 64 * words, static_cast<int>(runs->size())});
}

// At least as many as there are runs: one allocation instead of many, whose fresh memory would cost
// more than the work where runs are many.
size_t CountRuns(const BitMask& mask) {
  int count = 0;
  for (int v = 0; v < mask.height_px(); ++v) {
    const uint64_t* bits = mask.row(v);
    for (int word = 0; word < mask.words(); ++word) {
      count += CountBits(bits[word] & ~(bits[word] << 1));
    }
  }
  return static_cast<size_t>(count);
}

// A run's `group` is the index of an earlier run of its group, or its own: a forest.
int Root(std::vector<PixelRun>& runs, int index) {
  auto at = static_cast<size_t>(index);
  while (runs[at].group != static_cast<int>(at)) {
    const auto parent = static_cast<size_t>(runs[at].group);
    runs[at].group = runs[parent].group;  // halves the path
    at = parent;
  }
  return static_cast<int>(at);
}

void Join(std::vector<PixelRun>& runs, int one, int other) {
  one = Root(runs, one);
  other = Root(runs, other);
  if (one == other) return;
  if (one > other) std::swap(one, other);
  runs[static_cast<size_t>(other)].group = one;
}

// Joins runs [begin, end) of one row with those [above, begin) of the row above.
void JoinRows(std::vector<PixelRun>& runs, size_t above, size_t begin, size_t end) {
  for (size_t here = begin; above < begin && here < end;) {
    const PixelRun& upper = runs[above];
    const PixelRun& lower = runs[here];
    if (upper.u_begin_px <= lower.u_end_px && lower.u_begin_px <= upper.u_end_px) {
      Join(runs, static_cast<int>(above), static_cast<int>(here));
    }
    if (upper.u_end_px <= lower.u_end_px) {
      ++above;
    } else {
      ++here;
    }
  }
}

}  // namespace

PixelGroups GroupPixels(const BitMask& mask) {
  PixelGroups groups;
  std::vector<PixelRun>& runs = groups.runs;
  runs.reserve(CountRuns(mask));
  size_t above = 0;
  for (int v = 0; v < mask.height_px(); ++v) {
    const size_t begin = runs.size();
    AppendRuns(mask.row(v), mask.words(), v, &runs);
    JoinRows(runs, above, begin, runs.size());
    above = begin;
  }
  // A root is the first run of its group, so its number is known before those that point to it.
  for (size_t i = 0; i < runs.size(); ++i) {
    const auto root = static_cast<size_t>(runs[i].group);
    runs[i].group = root == i ? groups.count++ : runs[root].group;
  }
  return groups;
}

}  // namespace geon::attention
