#include "active_vision/view_gain.h"

#include <utility>

#include "active_vision/view_table.h"
#include "base/contracts.h"

namespace geon::active_vision {

double ViewGain(const std::array<double, kGeonLabelCount>& posterior_1, int turns) {
  return ViewGain(TrainedViewTable().gain, posterior_1, turns);
}

std::array<size_t, 2> LikeliestTwo(const std::array<double, kGeonLabelCount>& posterior_1) {
  size_t first = 0, second = 1;
  if (posterior_1[second] > posterior_1[first]) std::swap(first, second);
  for (size_t k = 2; k < posterior_1.size(); ++k) {
    if (posterior_1[k] > posterior_1[first]) {
      second = first;
      first = k;
    } else if (posterior_1[k] > posterior_1[second]) {
      second = k;
    }
  }
  return {first, second};
}

double ViewGain(const ViewGainTable& table, const std::array<double, kGeonLabelCount>& posterior_1,
                int turns) {
  Require(turns >= 1 && turns <= kViewTurns, "ViewGain: turns", turns, "must be 1 to 6");
  const auto [first, second] = LikeliestTwo(posterior_1);
  return table[first][second][static_cast<size_t>(turns) - 1];
}

}  // namespace geon::active_vision
