#pragma once

#include <filesystem>
#include <vector>

#include "base/status.h"
#include "procs/geon/setup_checks.h"
#include "sensor/scan_set.h"

namespace geon::cli {

struct FloorCheckOptions {
  double window_m = 0.03;   // a point farther from where the floor should be is no floor
  double height_m = 0.005;  // a floor seen so much too high or low is a fault
  double laser_m = 0.004;   // the two lasers see it so much apart
  double slope_rad = 0.01;  // it seems to lean so much
  int min_points = 60;      // of each laser
};

// Where the stripes of recorded scans put the floor, which is z = 0 of every scan's frame L.
struct FloorAgreement {
  int scans = 0;
  int horizontal_points = 0, vertical_points = 0;
  double horizontal_m = 0.0, vertical_m = 0.0;  // median height by either laser
  bool leans_known = false;                     // the points are spread enough to tell
  double pitch_rad = 0.0, roll_rad = 0.0;       // slope forward and to the left
};

// From the range profiles of scans on the floor.
FloorAgreement MeasureFloor(const std::vector<sensor::RangeProfile>& profiles,
                            const FloorCheckOptions& options = {});

// What the agreement means and what to do.
SetupCheck JudgeFloor(const FloorAgreement& floor, const FloorCheckOptions& options = {});

// The range profiles of all scans in a log whose target stood on the floor. Errors: no log.
Result<std::vector<sensor::RangeProfile>> FloorProfiles(const std::filesystem::path& log);

}  // namespace geon::cli
