#include "recognition/profile_ends.h"

#include <algorithm>
#include <cmath>

namespace geon::recognition {

std::vector<ProfileEnds> FindProfileEnds(std::span<const TargetProfile> profiles,
                                         sensor::Laser laser, const BwCamera& camera) {
  const int along = laser == sensor::Laser::kHorizontal ? 0 : 1;
  std::vector<ProfileEnds> ends;
  for (const TargetProfile& profile : profiles) {
    if (profile.laser != laser || profile.segments.empty()) continue;
    ProfileEnds e;
    e.fraction = profile.fraction;
    e.first_B_m = camera.InCamera(profile.first_L());
    e.last_B_m = camera.InCamera(profile.last_L());
    e.length_m = std::abs(e.last_B_m[along] - e.first_B_m[along]);
    ends.push_back(e);
  }
  std::stable_sort(ends.begin(), ends.end(), [](const ProfileEnds& a, const ProfileEnds& b) {
    return a.fraction < b.fraction;
  });
  return ends;
}

}  // namespace geon::recognition
