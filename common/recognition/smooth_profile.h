#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sensor/scan_set.h"

namespace geon::recognition {

enum class Smoothing { kNone, kMedian, kGaussian };

struct SmoothingOptions {
  Smoothing kind = Smoothing::kMedian;
  // The window reaches this far to each side of a pixel. The thesis names no size; 2 (five pixels)
  // drops two neighbouring spikes and leaves corners where they are.
  int half_width_px = 7;
  double gaussian_sigma_px = 1.2;
  void Validate() const;  // throws ContractViolation
};

// A copy of `profile` with its depths smoothed along the stripe.
//
// Source: thesis section 5.1 and figure 5.2: the median, because a Gaussian spreads a spike to its
// neighbours. The quantity smoothed is z of the B/W camera, which the rangefinder measures per
// pixel (3.7-3.9); every point then moves along its own viewing ray (3.10). The window ends at a
// missing pixel: nothing is smoothed across a gap.
//
// `p_LB_m`, `R_LB`: the B/W camera at this stripe, in frame L.
sensor::RangeProfile SmoothProfile(const sensor::RangeProfile& profile,
                                   const Eigen::Vector3d& p_LB_m, const Eigen::Matrix3d& R_LB,
                                   const SmoothingOptions& options);

// Its two steps. The depths of a profile (ProfileDepths), smoothed; with Smoothing::kNone all stay.
std::vector<double> SmoothDepths(std::span<const int> pixel, std::span<const double> depth_m,
                                 const SmoothingOptions& options);
// The points of a profile, each moved along its viewing ray from its depth to the smoothed one.
std::vector<Eigen::Vector3d> MoveAlongRays(std::span<const Eigen::Vector3d> p_L_m,
                                           std::span<const double> depth_m,
                                           std::span<const double> smooth_m,
                                           const Eigen::Vector3d& p_LB_m);

}  // namespace geon::recognition
