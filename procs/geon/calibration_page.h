#pragma once

#include <string>

#include "calibration/calibrate_rig.h"
#include "geometry/calibrated_rig.h"

namespace geon::cli {

// Which unknowns the pictures hardly tell, in a sentence.
std::string WeakInWords(const geometry::CalibratedRig& record);

// How good a calibration of the rig is, as one self-contained HTML page without scripts: predicted
// range errors, residuals, where in the pictures the board was, every unknown with its standard
// deviation, and what was fixed.
std::string CalibrationPage(const geometry::CalibratedRig& record,
                            const calibration::RigCalibration& found,
                            const calibration::RigObservations& observations);

}  // namespace geon::cli
