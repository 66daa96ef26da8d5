#include "active_vision/head_angles.h"

#include <algorithm>

namespace geon::active_vision {

HeadAngles HeadLimits::Clamp(HeadAngles head) const {
  return {std::clamp(head.pan_rad, pan_min_rad, pan_max_rad),
          std::clamp(head.tilt_rad, tilt_min_rad, tilt_max_rad)};
}

}  // namespace geon::active_vision
