#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace geon::recognition {

struct DifferenceOfSlopeOptions {
  int window = 10;  // W, samples of each fitted line (section 5.3.1)
  int gap = 3;      // M, samples between them, at least the arc length of a corner
  // theta_Smax: within +-this the curve is straight. Section 5.3.1 gives no values for this and the
  // next two; these come from a random search on synthetic views (see recognize_geon.h).
  double zero_range_rad = 0.021;
  int curve_width = 38;     // s_curve, samples: wider peaks are curves
  double corner_rad = 1.5;  // theta_corner: higher peaks are corners
  // A negative peak must fall below minus this, and be wider than this many samples, to count as a
  // concavity (figure 5.11): a dent of a few samples is noise.
  double concave_rad = 0.17;
  int concave_width = 11;
  // ... and minus so many standard deviations of theta's own noise: at 1.6 m that is 2.5 times what
  // it is at 1.0 m.
  double concave_noise_1 = 3.2;
  void Validate() const;  // throws ContractViolation
};

// Difference of slope along a curve: theta[i] belongs to sample first + i.
struct ThetaPlot {
  int first = 0;
  std::vector<double> theta_rad;  // positive: convex (clockwise)
  double noise_rad = 0.0;         // standard deviation of theta where the curve is straight
};

// What a profile is made of.
struct CurveFeatures {
  int curves = 0;
  int corners = 0;
  int concavities = 0;
};

// The theta-plot of O'Gorman's method: at each sample, the angle between the lines fitted to the W
// samples before and the W samples after a gap of M.
//
// Source: thesis section 5.3.1, figure 5.7 [O'Gorman 1988]. Deviation: the lines are fitted by
// total least squares and directed along the walk, since a regression of depth on position has no
// answer where the profile runs in depth. Empty when the curve has fewer than 2 W + M samples.
ThetaPlot ComputeThetaPlot(std::span<const Eigen::Vector2d> curve_m,
                           const DifferenceOfSlopeOptions& options);

// The noise of theta for points `points_per_sample_1` to a sample, each `noise_m` off the curve
// (standard deviation), and samples `step_m` apart: that of the difference of two regressions.
double ThetaNoise(double noise_m, double points_per_sample_1, double step_m,
                  const DifferenceOfSlopeOptions& options);

// Peaks of the theta-plot: width and height tell corner from curve; low and narrow is noise; high
// and wide is a corner right beside a curve (figure 5.9), both of which are counted.
CurveFeatures FindFeatures(const ThetaPlot& plot, const DifferenceOfSlopeOptions& options);

}  // namespace geon::recognition
