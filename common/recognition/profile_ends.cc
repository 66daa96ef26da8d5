#include "recognition/profile_ends.h"

#include <algorithm>
#include <cmath>

namespace geon::recognition {

std::vector<ProfileEnds> FindProfileEnds(std::span<const TargetProfile> profiles,
                                         sensor::Laser laser, const Eigen::Vector3d& p_LB_m,
                                         const Eigen::Matrix3d& R_LB) {
  const int along = laser == sensor::Laser::kHorizontal ? 0 : 1;
  std::vector<ProfileEnds> ends;
  for (const TargetProfile& profile : profiles) {
    if (profile.laser != laser || profile.segments.empty()) continue;
    ProfileEnds e;
    e.fraction = profile.fraction;
    e.first_B_m = R_LB.transpose() * (profile.first_L() - p_LB_m);
    e.last_B_m = R_LB.transpose() * (profile.last_L() - p_LB_m);
    e.length_m = std::abs(e.last_B_m[along] - e.first_B_m[along]);
    ends.push_back(e);
  }
  std::stable_sort(ends.begin(), ends.end(), [](const ProfileEnds& a, const ProfileEnds& b) {
    return a.fraction < b.fraction;
  });
  return ends;
}

}  // namespace geon::recognition
