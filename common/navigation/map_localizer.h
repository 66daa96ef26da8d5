#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "geometry/rigid_transform.h"
#include "navigation/floor_obstacles.h"
#include "navigation/occupancy_grid.h"

namespace geon::navigation {

struct MapLocalizerOptions {
  // Odometry, one sigma: by how much of every turn it is off, always the same way; and what it errs
  // by besides for 1 m driven or 1 rad turned, growing with the root of these.
  double turn_scale_1 = 0.01;
  double slip_m = 0.01;
  double slip_rad = 0.01;

  // Pictures, one sigma: how far the camera is tilted, about x and about y of R; besides, a point
  // where an obstacle meets the floor is off by point_m + point_per_m * its distance, what the map
  // is off by included.
  double tilt_rad = 0.015;
  double point_m = 0.02;
  double point_per_m = 0.015;
  // The points of one picture err together: all count as much as so many that do not.
  double independent_1 = 8.0;

  // A picture counts when the robot moved by one of these since the last that did.
  double every_m = 0.10;
  double every_rad = 0.10;

  std::optional<std::string> Validate() const;
};

// Where the robot is on its own map: odometry, corrected by how the obstacles in floor pictures lie
// on those that the map has already. By how much odometry misjudges turns is learned with it, so
// that what a look all round taught still helps where no obstacle is in sight.
//
// An iterated extended Kalman filter: odometry predicts, and every obstacle point is a measurement
// of its distance to the line through the map's points round it, where these lie on a line. What
// the picture does not tell, such as the place along a single wall, stays as odometry has it. How
// the camera was tilted is estimated anew for every picture: a wall seen by a camera that leans to
// the side looks turned.
//
// Source: Thrun et al., "Probabilistic Robotics" (2005), ch. 3 and 5.4 (the filter, odometry as its
// input); Censi, "An ICP variant using a point-to-line metric", ICRA 2008 (the residuals);
// Martinelli et al., "Simultaneous localization and odometry self calibration", Autonomous Robots
// 2007 (the scale as a state). Deviation: no scale of distance; what floor pictures are off by
// grows with the distance, which looks like one.
//
// Frames: O, of odometry; W, of the map, the same as O when the map began. No clock.
class MapLocalizer {
 public:
  explicit MapLocalizer(const MapLocalizerOptions& options);

  // One floor picture, taken where odometry says X_OR by a camera at p_RF; in the order of time,
  // and before the picture goes into the map.
  void See(const geometry::RigidTransform& X_OR, std::span<const FloorColumn> columns,
           const Eigen::Vector3d& p_RF_m, const OccupancyGrid& map);
  // W and O are the same from here on, as when odometry and map start anew.
  void Reset();

  const geometry::RigidTransform& X_WO() const { return X_WO_; }
  // What was learned: a turn is (1 + scale) times what odometry says.
  double turn_scale_1() const { return state_(3); }

 private:
  using State = Eigen::Vector4d;  // x_m, y_m, heading_rad in W; scale of turns
  using Covariance = Eigen::Matrix4d;

  void Predict(const geometry::RigidTransform& X_OR);
  void Correct(std::span<const Eigen::Vector2d> points_R_m, const Eigen::Vector3d& p_RF_m,
               const OccupancyGrid& map);

  MapLocalizerOptions options_;
  State state_ = State::Zero();
  Covariance covariance_;
  geometry::RigidTransform X_WO_ = geometry::RigidTransform::Identity();
  std::optional<geometry::RigidTransform> X_OR_;  // of the last picture
  double moved_m_ = 0.0;                          // since the last picture that counted
  double turned_rad_ = 0.0;
};

}  // namespace geon::navigation
