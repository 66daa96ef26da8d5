#pragma once

#include <string>

#include "base/status.h"
#include "geometry/calibrated_rig.h"

namespace geon::config {

// The file format geon.rig.v1: YAML with units in its keys, numbers that come back bit for bit, and
// on the last line the hash of all before it, so that no calibration is edited or cut unnoticed.
std::string SerializeCalibratedRig(const geometry::CalibratedRig& calibrated);

// Strict. `name` stands for the file in errors. The floor camera, which the file does not hold, and
// X_RF stay those of `drawn`. Errors: another hash, a key missing, unknown or ill-typed, a rotation
// or normal that is none, a picture of no size.
Result<geometry::CalibratedRig> ParseCalibratedRig(const std::string& text, const std::string& name,
                                                   const geometry::SensorRig& drawn);

// Whether the rig can be the one that was drawn: same picture sizes, nothing farther off than a
// mounting can be (positions 20 mm, directions 3 degrees, focal lengths 10 %). Says what is not.
Status CheckAgainstDrawing(const geometry::SensorRig& calibrated, const geometry::SensorRig& drawn);

}  // namespace geon::config
