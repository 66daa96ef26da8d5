#include "active_vision/target_middle.h"

#include <algorithm>
#include <vector>

namespace geon::active_vision {
namespace {

constexpr double kNear_m = 0.30;
constexpr double kAboveSupport_m = 0.015;
constexpr double kOnColor_1 = 0.5;
constexpr size_t kFewest = 20;
constexpr double kOutliers_1 = 0.02;  // at either end

double MiddleOf(std::vector<double> values_m) {
  const auto at = [&](double share_1) {
    const auto place = values_m.begin() +
                       static_cast<ptrdiff_t>(share_1 * static_cast<double>(values_m.size() - 1));
    std::nth_element(values_m.begin(), place, values_m.end());
    return *place;
  };
  const double low_m = at(kOutliers_1);
  return 0.5 * (low_m + at(1.0 - kOutliers_1));
}

}  // namespace

std::optional<Eigen::Vector2d> TargetMiddle(std::span<const sensor::RangeProfile> profiles,
                                            const Eigen::Vector2d& foot_L_m) {
  std::vector<double> x_m, y_m;
  for (const sensor::RangeProfile& profile : profiles) {
    for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
      const Eigen::Vector3d& p_m = profile.p_L_m[i];
      if (p_m.z() < kAboveSupport_m || (p_m.head<2>() - foot_L_m).norm() > kNear_m) continue;
      if (!profile.on_color_1.empty() && profile.on_color_1[i] < kOnColor_1) continue;
      x_m.push_back(p_m.x());
      y_m.push_back(p_m.y());
    }
  }
  if (x_m.size() < kFewest) return std::nullopt;
  return Eigen::Vector2d(MiddleOf(std::move(x_m)), MiddleOf(std::move(y_m)));
}

}  // namespace geon::active_vision
