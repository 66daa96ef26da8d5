#pragma once

#include <cstdint>

#include "sensor/scan_set.h"

namespace geon::sensor {

// What became of a stripe (RANGE_PROFILE's STATUS_*).
enum class ProfileStatus {
  kOk = 0,  // enough points lie on the target
  kMissing =
      1,  // no laser light where it was expected, or too little of it on the target: lay it again
  kRefused = 2,  // the stripe answers no plan that is known, or its image cannot be read
};

// A range profile together with what the recognizer tells the planner about it: the planner's
// acknowledgement of one stripe.
struct MeasuredProfile {
  RangeProfile profile;
  int32_t attempt = 0;
  ProfileStatus status = ProfileStatus::kMissing;
  int32_t on_target = 0;  // points left after background removal (thesis section 5.1)
};

}  // namespace geon::sensor
