#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sensor/scan_set.h"

namespace geon::recognition {

// Source: thesis sections 5.3 and 5.4, figures 5.5 and 5.10.
struct SegmentOptions {
  // Two neighbouring points further apart than this belong to two segments, whether pixels are
  // missing between them or not. More than what a grazing surface or a dark fleck leaves, less than
  // the opening of a bent geon.
  double split_m = 0.05;
  // A segment shorter than this is a stray reflection and is dropped.
  double shortest_m = 0.013;
  double shortest_share_1 = 0.11;  // ... or shorter than this part of the longest segment
  int fewest_points = 5;
  void Validate() const;  // throws ContractViolation
};

// The points [begin, end) of a run.
struct PointRange {
  size_t begin = 0;
  size_t end = 0;
  size_t size() const { return end - begin; }
};

// The parts of a profile that hang together, in the order of its pixels (figure 5.10).
std::vector<PointRange> FindSegments(std::span<const Eigen::Vector3d> p_L_m,
                                     const SegmentOptions& options);

// The profile as the plane curve that the thesis draws: abscissa along the stripe (x of the B/W
// camera for a horizontal stripe, y for a vertical one), ordinate towards the camera (-z), metres.
// Walked in the order of its pixels a convex surface turns clockwise.
std::vector<Eigen::Vector2d> PlaneCurve(std::span<const Eigen::Vector3d> p_L_m, sensor::Laser laser,
                                        const Eigen::Matrix3d& R_LB);

// `samples` points at equal steps of arc length, each the mean of the curve over its own step.
// `arc_m` is the curve's ArcLengths.
//
// Not in the thesis, which counts W and M in pixels: with 1 mm of noise and half a millimetre
// between pixels the slope of ten pixels is noise. Equal arcs make W and M fractions of the
// profile, whatever the distance and the camera's resolution.
std::vector<Eigen::Vector2d> ResampleEqualArc(std::span<const Eigen::Vector2d> curve_m,
                                              std::span<const double> arc_m, int samples);

// From the first point to each point along the curve, and to the last one.
std::vector<double> ArcLengths(std::span<const Eigen::Vector2d> curve_m);
double ArcLength(std::span<const Eigen::Vector2d> curve_m);

}  // namespace geon::recognition
