#include "active_vision/order_stripes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

double AxisTime(double angle_rad, const HeadMotion& motion) {
  const double ramps_rad = motion.speed_rad_s * motion.speed_rad_s / motion.acceleration_rad_s2;
  if (angle_rad < ramps_rad) return 2.0 * std::sqrt(angle_rad / motion.acceleration_rad_s2);
  return angle_rad / motion.speed_rad_s + motion.speed_rad_s / motion.acceleration_rad_s2;
}

}  // namespace

double TurnTime(const HeadAngles& from, const HeadAngles& to, const HeadMotion& motion) {
  return std::max(AxisTime(std::abs(to.pan_rad - from.pan_rad), motion),
                  AxisTime(std::abs(to.tilt_rad - from.tilt_rad), motion));
}

std::vector<size_t> OrderStripes(const std::vector<sensor::PlannedStripe>& stripes,
                                 const HeadAngles& from, const HeadMotion& motion) {
  std::vector<size_t> order(stripes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto vertical = std::stable_partition(order.begin(), order.end(), [&](size_t k) {
    return stripes[k].laser == sensor::Laser::kHorizontal;
  });
  Require(vertical - order.begin() <= 3 && order.end() - vertical <= 3,
          "OrderStripes: at most three stripes of each laser");
  const auto duration_s = [&] {
    double sum_s = 0.0;
    HeadAngles at = from;
    for (const size_t k : order) {
      const HeadAngles next{stripes[k].pan_rad, stripes[k].tilt_rad};
      sum_s += TurnTime(at, next, motion);
      at = next;
    }
    return sum_s;
  };
  std::vector<size_t> best = order;
  double best_s = duration_s();
  // Every order of either laser's.
  do {
    do {
      const double sum_s = duration_s();
      if (sum_s >= best_s) continue;
      best_s = sum_s;
      best = order;
    } while (std::next_permutation(vertical, order.end()));
  } while (std::next_permutation(order.begin(), vertical));
  return best;
}

}  // namespace geon::active_vision
