#include "recognition/profile_noise.h"

#include <cmath>
#include <vector>

#include "recognition/median.h"

namespace geon::recognition {

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
