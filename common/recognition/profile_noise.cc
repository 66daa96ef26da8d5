#include "recognition/profile_noise.h"

#include <cmath>

#include "recognition/median.h"

namespace geon::recognition {

std::vector<double> ProfileDepths(std::span<const Eigen::Vector3d> p_L_m,
                                  const Eigen::Vector3d& p_LB_m, const Eigen::Matrix3d& R_LB) {
  const Eigen::Vector3d forward_L = R_LB.col(2);
  std::vector<double> depth_m(p_L_m.size());
  for (size_t i = 0; i < p_L_m.size(); ++i) depth_m[i] = forward_L.dot(p_L_m[i] - p_LB_m);
  return depth_m;
}

double DepthNoise(std::span<const int> pixel, std::span<const double> depth_m) {
  std::vector<double> differences_m(pixel.size());
  size_t count = 0;
  for (size_t i = 3; i < pixel.size(); ++i) {
    differences_m[count] =
        std::abs(depth_m[i] - depth_m[i - 3] - 3.0 * (depth_m[i - 1] - depth_m[i - 2]));
    if (pixel[i] - pixel[i - 3] == 3) ++count;  // else the next one takes its place
  }
  differences_m.resize(count);
  constexpr double kMedianOfMagnitude = 0.6745;     // of a normal variable, in sigmas
  const double third_difference = std::sqrt(20.0);  // sigma of 1, -3, 3, -1
  return Median(std::move(differences_m)) / (kMedianOfMagnitude * third_difference);
}

}  // namespace geon::recognition
