#pragma once

#include <array>
#include <vector>

#include "base/status.h"
#include "calibration/rig_observations.h"
#include "calibration/rig_unknowns.h"

namespace geon::calibration {

// What was measured, each with its own noise.
enum class Measurement { kStripeCorners = 0, kColorCorners, kHorizontalStripe, kVerticalStripe };
inline constexpr int kMeasurements = 4;

struct Residuals {
  int count = 0;        // corners (two coordinates each) or stripe points
  double rms_px = 0.0;  // of a coordinate, by the median: outliers do not count
  int outliers = 0;     // beyond four times that
};

struct BundleOptions {
  DrawingTolerances tolerances;
  double ptu_rad = 0.0003;  // standard deviation of an encoder's angle (0.05 degrees a count)
  double corner_px = 0.05;  // of a corner's coordinate, before the pictures told better
  double stripe_px = 0.1;   // of a stripe's centre
  int iterations = 100;     // of one solve
  int stripe_points = 40;   // taken of one stripe in one view, evenly
};

struct Bundle {
  RigUnknowns unknowns;
  // Of the unknowns, row-major: what pictures and priors together leave open.
  Eigen::Matrix<double, RigUnknowns::kAll, RigUnknowns::kAll, Eigen::RowMajor> covariance;
  std::array<Residuals, kMeasurements> residuals;
  // X_PBoard of every stop.
  std::vector<geometry::RigidTransform> boards;
};

// One least-squares bundle over lenses, camera poses, axes, laser planes, one board pose a stop and
// the angles of every view.
//
// Source: Triggs et al., "Bundle adjustment - a modern synthesis", 2000; laser points are bound to
// board and fan at once, as in Zhang & Pless, "Extrinsic calibration of a camera and laser range
// finder", 2004. Steps: board poses by PnP with the drawn camera; solve with a Cauchy loss; measure
// each kind's noise by its median residual; solve again with it; covariance. Priors: the drawing
// and the encoders. Stops must be numbered from 0 and each seen at least once by the B/W camera.
// Errors: the solver does not converge, or nothing holds some unknown.
Result<Bundle> AdjustRig(const RigObservations& observations, const geometry::SensorRig& drawn,
                         const BundleOptions& options = {});

}  // namespace geon::calibration
