#include "recognition/profile_ends.h"

#include <algorithm>

namespace geon::recognition {
std::vector<ProfileEnds> FindProfileEnds(const std::vector<sensor::RangeProfile>& profiles,
                                         sensor::Laser laser, const Eigen::Vector3d& p_LB_m,
                                         const Eigen::Matrix3d& R_LB) {
  std::vector<ProfileEnds> ends;
  double distance_sum_m = 0.0;
  for (const sensor::RangeProfile& profile : profiles) {
    if (profile.laser != laser || profile.p_L_m.size() < 2) continue;
    ProfileEnds e;
    e.fraction = profile.fraction;
    const Eigen::Vector3d first_B = R_LB.transpose() * (profile.p_L_m.front() - p_LB_m);
    const Eigen::Vector3d last_B = R_LB.transpose() * (profile.p_L_m.back() - p_LB_m);
    if (first_B.z() <= 0.0 || last_B.z() <= 0.0) continue;
    e.first_m = first_B.head<2>() / first_B.z();
    e.last_m = last_B.head<2>() / last_B.z();
    e.length_m = (last_B - first_B).norm();
    distance_sum_m += first_B.z() + last_B.z();
    ends.push_back(e);
  }
  const double distance_m =
      distance_sum_m / (2.0 * static_cast<double>(std::max<size_t>(ends.size(), 1)));
  for (ProfileEnds& e : ends) {
    e.first_m *= distance_m;
    e.last_m *= distance_m;
  }
  std::stable_sort(ends.begin(), ends.end(), [](const ProfileEnds& a, const ProfileEnds& b) {
    return a.fraction < b.fraction;
  });
  return ends;
}

}  // namespace geon::recognition
