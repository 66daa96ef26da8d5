#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "active_vision/fuse_views.h"
#include "sensor/geon_verdict.h"

namespace geon::mission {

// What was seen of one target, from which sides, and from which side another look would tell most.
// Bearings are of W, from the target to the robot.
class TargetViews {
 public:
  void Clear();
  // A scan's verdict. `middle_W_m`: where the target stands by that scan.
  void Add(const sensor::GeonVerdict& verdict, double bearing_rad,
           const Eigen::Vector2d& middle_W_m);
  int count() const { return static_cast<int>(verdicts_.size()); }
  // The middle by all scans; there must be one.
  Eigen::Vector2d middle_W_m() const;
  // All verdicts together; there must be one.
  sensor::GeonVerdict Fused() const { return active_vision::FuseViews(verdicts_); }

  // The side from which another look tells most for what the drive costs (view_gain.h), among those
  // that are none of the sides seen so far nor given up; nothing when none tells anything.
  std::optional<double> NextBearing() const;
  // No way leads to that side.
  void GiveUp(double bearing_rad) { closed_rad_.push_back(bearing_rad); }

 private:
  std::vector<sensor::GeonVerdict> verdicts_;
  std::vector<double> bearings_rad_;  // of the verdicts
  std::vector<double> closed_rad_;
  Eigen::Vector2d sum_W_m_ = Eigen::Vector2d::Zero();
};

}  // namespace geon::mission
