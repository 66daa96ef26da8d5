#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "geometry/sensor_rig.h"
#include "rangefinder/look_up_table.h"

namespace geon::recognizer {

// The look-up tables of both lasers (thesis 3.2), as `geon calibrate lut` leaves them.
struct StripeCalibration {
  rangefinder::LookUpTable horizontal;
  rangefinder::LookUpTable vertical;
  std::string directory;
  std::string hash;  // of both files
};

// Where distances come from: the tables, each of which was measured by itself, or the rig's own
// geometry, when that was calibrated as a whole.
enum class Ranging { kLookUpTable, kRig };

// Reads horizontal.lut and vertical.lut of a folder and checks that they belong to this rig's
// camera.
Result<StripeCalibration> LoadStripeCalibration(const std::filesystem::path& directory,
                                                const geometry::SensorRig& rig);

}  // namespace geon::recognizer
