#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "calibration/fit_floor.h"
#include "calibration/rig_bundle.h"
#include "geometry/calibrated_rig.h"
#include "sensor/stripe.h"

namespace geon::calibration {

struct CalibrationOptions {
  BundleOptions bundle;
  FloorOptions floor;
  int min_stops = 2;
  int min_views = 12;  // with corners in the B/W picture, of all stops
  int min_color_views = 6;
  int min_stripe_points = 200;        // of each laser
  double min_distance_ratio_1 = 1.3;  // of the farthest stop to the nearest
  // Of the baselines between cameras and lasers to those drawn: more is a wrong square size.
  double max_scale_error_1 = 0.04;
  double max_focal_error_1 = 0.06;
  double max_corner_rms_px = 0.5;
  double max_stripe_rms_px = 0.6;
  // An unknown whose standard deviation is above this share of its prior's is told by the drawing
  // rather than by the pictures.
  double weak_1 = 0.3;

  Status Validate() const;
};

// What one range measured by the rig is off by because the rig is not known better: the standard
// deviation, common to all points there.
struct RangeSigma {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double distance_m = 0.0;
  double sigma_m = 0.0;
};

struct RigCalibration {
  geometry::SensorRig rig;
  RigUnknowns unknowns;
  std::array<double, RigUnknowns::kAll> sigma{};        // standard deviations of the unknowns
  std::array<double, RigUnknowns::kAll> prior_sigma{};  // what the drawing alone would give
  std::array<Residuals, kMeasurements> residuals;
  std::vector<RangeSigma> range_sigmas;  // at 0.7, 1.0, 1.5 and 2.0 m, both lasers
  std::vector<int> weak;                 // unknowns told by the drawing, not by the pictures
  std::vector<double> stop_distances_m;  // from the B/W camera to the board, of every stop
  double baseline_scale_1 = 1.0;         // of the baselines found to those drawn
  int views = 0;                         // that show the board to the B/W camera
  std::optional<FloorFit> floor;
};

// The whole rig from one fixed chessboard seen at many head angles from a few stops of the robot,
// and, if there are floor views, from the floor.
//
// Source: thesis 3.2 (what has to be calibrated); Zhang, "A flexible new technique for camera
// calibration", 2000; see AdjustRig. Errors say what is wrong with the observations: the board not
// seen, too few views or stops, all stops at about one distance, a laser without points, pictures
// that do not fit, a focal length far off the drawing, squares of another size than said.
Result<RigCalibration> CalibrateRig(const RigObservations& observations,
                                    const geometry::SensorRig& drawn,
                                    const CalibrationOptions& options = {});

// The same with units and in words, as it is kept in a file.
geometry::CalibratedRig RecordOf(const RigCalibration& calibration, const std::string& date);

}  // namespace geon::calibration
