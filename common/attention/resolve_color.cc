#include "attention/resolve_color.h"

#include <utility>
#include <vector>

#include "attention/pixel_groups.h"

namespace geon::attention {
namespace {

BitMask Either(BitMask one, const BitMask& other) {
  for (int v = 0; v < one.height_px(); ++v) {
    for (int word = 0; word < one.words(); ++word) one.row(v)[word] |= other.row(v)[word];
  }
  return one;
}

template <typename Wanted>
void TakeGroups(const PixelGroups& groups, const Wanted& wanted, BitMask* target) {
  for (const PixelRun& run : groups.runs) {
    if (wanted(static_cast<size_t>(run.group))) target->Set(run.v_px, run.u_begin_px, run.u_end_px);
  }
}

void TakeRim(const BitMask& rim, BitMask* target) {
  const PixelGroups groups = GroupPixels(Either(rim, *target));
  std::vector<bool> holds_target(static_cast<size_t>(groups.count), false);
  for (const PixelRun& run : groups.runs) {
    if (target->Count(run.v_px, run.u_begin_px, run.u_end_px) > 0) {
      holds_target[static_cast<size_t>(run.group)] = true;
    }
  }
  TakeGroups(
      groups, [&](size_t group) { return holds_target[group]; }, target);
}

// The rows above and below row v, and what they hold: the group's own pixels and target pixels.
// Beyond the image every pixel is the group's own.
class RowsBeside {
 public:
  RowsBeside(const BitMask& group_mask, const BitMask& target)
      : group_mask_(group_mask),
        target_(target),
        none_(static_cast<size_t>(target.words()), 0),
        all_(static_cast<size_t>(target.words()), ~uint64_t{0}) {}

  void GoTo(int v_px) {
    for (int side = 0; side < 2; ++side) {
      const int v = v_px + 2 * side - 1;
      const bool inside = v >= 0 && v < target_.height_px();
      own_[side] = inside ? group_mask_.row(v) : all_.data();
      on_target_[side] = inside ? target_.row(v) : none_.data();
    }
  }
  // Pixels above and below [begin, end) that are target, less those that are neither.
  int Balance(int begin_px, int end_px) const {
    const int length = end_px - begin_px;
    const int word = begin_px / 64;
    const int first = begin_px % 64;
    if (first + length <= 64 && length <= 8) {  // the bits of both rows fit into one word
      const uint64_t wanted = (1U << length) - 1;
      const auto part = [&](const uint64_t* bits) { return bits[word] >> first & wanted; };
      const uint64_t twice = part(on_target_[0]) | part(on_target_[1]) << 8;
      return CountBits(part(own_[0]) | part(own_[1]) << 8 | twice << 16 | twice << 32) - 2 * length;
    }
    int balance = -2 * length;
    for (int side = 0; side < 2; ++side) {
      ForWords(begin_px, end_px, [&](int at, uint64_t wanted) {
        balance +=
            CountBits(own_[side][at] & wanted) + 2 * CountBits(on_target_[side][at] & wanted);
      });
    }
    return balance;
  }

 private:
  const BitMask& group_mask_;
  const BitMask& target_;
  std::vector<uint64_t> none_;
  std::vector<uint64_t> all_;
  const uint64_t* own_[2] = {};
  const uint64_t* on_target_[2] = {};
};

void TakeCannotTell(const BitMask& cannot_tell, BitMask* target) {
  const PixelGroups groups = GroupPixels(cannot_tell);
  std::vector<int> balance(static_cast<size_t>(groups.count), 0);  // of sides of the contour
  RowsBeside beside(cannot_tell, *target);
  int v_px = -1;
  for (const PixelRun& run : groups.runs) {
    if (run.v_px != v_px) beside.GoTo(v_px = run.v_px);
    int of_run = beside.Balance(run.u_begin_px, run.u_end_px);
    if (run.u_begin_px > 0) of_run += target->At(run.u_begin_px - 1, v_px) ? 1 : -1;
    if (run.u_end_px < target->width_px()) of_run += target->At(run.u_end_px, v_px) ? 1 : -1;
    balance[static_cast<size_t>(run.group)] += of_run;
  }
  TakeGroups(
      groups, [&](size_t group) { return balance[group] > 0; }, target);
}

}  // namespace

BitMask ResolveColor(PixelClasses classes) {
  BitMask target = std::move(classes.target);
  if (classes.rim.Any()) TakeRim(classes.rim, &target);
  if (classes.cannot_tell.Any()) TakeCannotTell(classes.cannot_tell, &target);
  return target;
}

}  // namespace geon::attention
