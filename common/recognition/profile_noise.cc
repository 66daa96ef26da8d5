#include "recognition/profile_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geon::recognition {

double DepthNoise(const sensor::RangeProfile& profile, const Eigen::Vector3d& p_LB_m,
                  const Eigen::Matrix3d& R_LB) {
  const Eigen::Vector3d forward_L = R_LB.col(2);
  std::vector<double> differences_m;
  for (size_t i = 3; i < profile.pixel.size(); ++i) {
    if (profile.pixel[i] - profile.pixel[i - 3] != 3) continue;
    const auto z_m = [&](size_t k) { return forward_L.dot(profile.p_L_m[k] - p_LB_m); };
    differences_m.push_back(std::abs(z_m(i) - z_m(i - 3) - 3.0 * (z_m(i - 1) - z_m(i - 2))));
  }
  if (differences_m.empty()) return 0.0;
  const auto middle = differences_m.begin() + static_cast<std::ptrdiff_t>(differences_m.size() / 2);
  std::nth_element(differences_m.begin(), middle, differences_m.end());
  constexpr double kMedianOfMagnitude = 0.6745;     // of a normal variable, in sigmas
  const double third_difference = std::sqrt(20.0);  // sigma of 1, -3, 3, -1
  return *middle / (kMedianOfMagnitude * third_difference);
}

}  // namespace geon::recognition
