#pragma once

#include <cstdint>

#include "base/status.h"
#include "calibration/rig_observations.h"
#include "geometry/sensor_rig.h"
#include "procs/geon/rig_frames.h"
#include "sim/sim_config.h"

namespace geon::cli {

struct RigSweepOptions {
  int stops = 5;  // of the robot, from 0.8 to 1.8 m before the board, to its left and right
  int columns = 5, rows = 3;  // of head poses at each stop
  double exposure_s = 0.25;   // of the B/W frame that shows the board through the laser's filter

  Status Validate() const;
};

// The calibration as the simulated robot would be led through it: one board on a stand in a room,
// the robot driven from stop to stop, at each the head swept over what keeps the board in both
// pictures; then turned to bare floor for the horizontal laser. Where to point is reckoned by the
// drawing.
RigSeries SimulatedRig(const geometry::SensorRig& drawn, const sim::SimOptions& options,
                       const calibration::Chessboard& board, const RigSweepOptions& sweep,
                       uint64_t seed);

}  // namespace geon::cli
