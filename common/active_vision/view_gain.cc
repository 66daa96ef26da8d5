#include "active_vision/view_gain.h"

#include <cmath>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

// Of what is open, the share that a look from so far round tells.
constexpr std::array<double, kViewTurns> kTold_1 = {0.35, 0.60, 0.45, 0.55, 0.40, 0.30};

}  // namespace

double ViewGain(const std::array<double, kGeonLabelCount>& posterior_1, int turns) {
  Require(turns >= 1 && turns <= kViewTurns, "ViewGain: turns must be 1 to 6");
  double open_1 = 0.0;
  for (const double p_1 : posterior_1) {
    if (p_1 > 0.0) open_1 -= p_1 * std::log(p_1);
  }
  return kTold_1[static_cast<size_t>(turns - 1)] * open_1;
}

}  // namespace geon::active_vision
