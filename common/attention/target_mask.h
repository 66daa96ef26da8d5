#pragma once

#include "attention/find_target.h"
#include "sensor/target_mask.h"

namespace geon::attention {

// The target of a sighting as runs of pixels (sensor/target_mask.h): a few hundred bytes for what
// the thesis binarises (4.1.2). Source: run-length coding of bilevel pictures, Golomb 1966. Head
// angles, scan_id, utime and seq are left 0. Throws ContractViolation without a target.
sensor::TargetMask MakeTargetMask(const TargetSighting& seen);

}  // namespace geon::attention
