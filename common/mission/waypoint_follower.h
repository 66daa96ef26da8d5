#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "navigation/velocity_law.h"

namespace geon::mission {

// Drives to one waypoint after another, gently up from the speed it has (velocity_law.h).
class WaypointFollower {
 public:
  // A waypoint at the robot's own place: stand. Frame R.
  navigation::DriveVelocity Go(double now_s, const Eigen::Vector2d& waypoint_R_m,
                               std::span<const Eigen::Vector2d> obstacles_R_m,
                               const navigation::VelocityLawOptions& options);
  // The robot stands; something else took over.
  void Rest();

  const Eigen::Vector2d& waypoint_R_m() const { return waypoint_R_m_; }

 private:
  Eigen::Vector2d waypoint_R_m_ = Eigen::Vector2d::Zero();
  double speed_m_s_ = 0.0;
  std::optional<double> last_s_;
};

}  // namespace geon::mission
