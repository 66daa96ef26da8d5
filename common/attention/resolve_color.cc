#include "attention/resolve_color.h"

#include <utility>

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

// Sides of a run on target pixels less those on others; pixels of `group_mask` are its own group's.
int ContourBalance(const PixelRun& run, const BitMask& group_mask, const BitMask& target) {
  int balance = 0;
  if (run.u_begin_px > 0) balance += target.At(run.u_begin_px - 1, run.v_px) ? 1 : -1;
  if (run.u_end_px < target.width_px()) balance += target.At(run.u_end_px, run.v_px) ? 1 : -1;
  for (const int v : {run.v_px - 1, run.v_px + 1}) {
    if (v < 0 || v >= target.height_px()) continue;
    const int sides =
        run.u_end_px - run.u_begin_px - group_mask.Count(v, run.u_begin_px, run.u_end_px);
    balance += 2 * target.Count(v, run.u_begin_px, run.u_end_px) - sides;
  }
  return balance;
}

void TakeCannotTell(const BitMask& cannot_tell, BitMask* target) {
  const PixelGroups groups = GroupPixels(cannot_tell);
  std::vector<int> balance(static_cast<size_t>(groups.count), 0);
  for (const PixelRun& run : groups.runs) {
    balance[static_cast<size_t>(run.group)] += ContourBalance(run, cannot_tell, *target);
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
