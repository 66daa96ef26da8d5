#pragma once

#include <Eigen/Core>
#include <random>
#include <span>
#include <vector>

#include "evaluation/scan_conditions.h"

namespace geon::evaluation {

// What is wrong with a stripe's peak in one line of the image.
struct StripeError {
  double offset_px = 0.0;
  bool missing = false;
};

// The errors of `lines` neighbouring lines: white noise, speckle (a first-order autoregression over
// about four lines), peaks that are reflections from elsewhere, and lines without a peak.
std::vector<StripeError> StripeErrors(size_t lines, const FaultOptions& faults,
                                      std::mt19937_64& random);

// What a depth camera's calibration leaves of errors in the offsets, all over one image.
//
// Source: Herrera, Kannala and Heikkila, "Joint depth and color camera calibration with distortion
// correction", 2012, for smooth patterns in the offsets; their sizes and the waves are ours.
class OffsetError {
 public:
  OffsetError(const FaultOptions& faults, std::mt19937_64& random);
  // At a place in pixels from the optical axis.
  double At(const Eigen::Vector2d& place_px) const;

 private:
  struct Wave {
    double height_px = 0.0;
    Eigen::Vector2d number_per_px = Eigen::Vector2d::Zero();
    double phase_rad = 0.0;
  };
  double offset_px_ = 0.0;
  std::vector<Wave> waves_;
};

// The depths (infinity: none) as a sensor sees them that matches patches: averaged, missing
// where the surface is steep, each end of a surface displaced by a draw of its own and lines beside
// it lost. As they are when none of these faults is asked for.
//
// Source: Khoshelham and Elberink, "Accuracy and resolution of Kinect depth data", 2012, section 3,
// for what such sensors do at edges; the forms are ours.
std::vector<double> MatchPatches(std::span<const double> depths_m, const FaultOptions& faults,
                                 std::mt19937_64& random);

}  // namespace geon::evaluation
