#pragma once

#include <string>
#include <vector>

#include "geometry/sensor_rig.h"

namespace geon::geometry {

// One quantity of a calibration in words, in the unit that people read.
struct RigEstimate {
  std::string part;         // "B/W camera"
  std::string what;         // "focal length"
  std::string unit;         // "px", "mm", "deg" or ""
  double difference = 0.0;  // from the drawing
  double sigma = 0.0;       // standard deviation
  bool weak = false;        // told by the drawing more than by the pictures
};

// How well one kind of measurement fits.
struct RigResidual {
  std::string what;  // "corners in the B/W pictures"
  int count = 0;
  double rms_px = 0.0;
  int outliers = 0;
};

// Predicted standard deviation of a range because the rig is not known better.
struct RigRangeSigma {
  std::string laser;  // "horizontal" or "vertical"
  double distance_m = 0.0;
  double sigma_m = 0.0;
};

// A rig as a calibration found it, with what says how good it is (file format geon.rig.v1). Its
// floor camera, and x, y and yaw of X_RP, are the drawing's.
struct CalibratedRig {
  SensorRig rig;
  std::string date;  // YYYY-MM-DD
  int stops = 0;     // of the robot before the board
  int views = 0;     // head poses in which the B/W camera saw the board
  std::vector<RigResidual> residuals;
  std::vector<RigRangeSigma> range_sigmas;
  std::vector<RigEstimate> estimates;
};

}  // namespace geon::geometry
