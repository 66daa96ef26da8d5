#include "attention/target_mask.h"

#include <limits>

#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr int kLongestRun = std::numeric_limits<int16_t>::max();

void AddRun(int length, std::vector<int16_t>* runs_px) {
  for (; length > kLongestRun; length -= kLongestRun) {
    runs_px->push_back(kLongestRun);
    runs_px->push_back(0);
  }
  runs_px->push_back(static_cast<int16_t>(length));
}

}  // namespace

sensor::TargetMask MakeTargetMask(const TargetSighting& seen) {
  Require(seen.target.has_value(), "MakeTargetMask: the sighting shows no target");
  sensor::TargetMask mask;
  mask.box = seen.target->box;
  bool on_target = false;
  int length = 0;
  for (int v = mask.box.v_px; v < mask.box.v_px + mask.box.h_px; ++v) {
    for (int u = mask.box.u_px; u < mask.box.u_px + mask.box.w_px; ++u) {
      const bool here = seen.mask[static_cast<size_t>(v * seen.width_px + u)] != 0;
      if (here != on_target) {
        AddRun(length, &mask.runs_px);
        on_target = here;
        length = 0;
      }
      ++length;
    }
  }
  AddRun(length, &mask.runs_px);
  return mask;
}

}  // namespace geon::attention
