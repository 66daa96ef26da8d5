#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"

namespace geon::navigation {

struct FloorObstacleOptions {
  double max_range_m = 3.0;  // farther ones are not asked for
  int min_run_px = 3;        // an obstacle fills at least so many pixels in its direction
  int column_step_px = 4;    // one direction for this many of the picture's columns

  bool IsValid(std::string* error) const;
};

// What the floor camera saw of the ground in one direction, straight away from below the camera:
// floor from `begin` (the picture's edge) to `end`, and whether something else begins there (or
// only the range or the picture ends).
struct FloorColumn {
  Eigen::Vector2d begin_R_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d end_R_m = Eigen::Vector2d::Zero();
  bool obstacle = false;
  // That is brighter than the floor and has no other colour: maybe a lamp's image in the floor.
  bool bright = false;
};

// Nearest points that are not floor, by direction, from left to right.
//
// Source: thesis section 4.3, assumptions (i) and (iii): the colour of the floor is uniform and
// known, whatever has another colour is an obstacle; "its location determined through a geometric
// transformation": the ray of the lowest such pixel meets the plane of the floor. X_RF is the pose
// of the camera on the robot; points are in R. Directions whose first pixel is already no floor end
// there: what is there is nearer than the picture shows.
//
// Deviation: not along the picture's columns, but along lines away from the point below the camera.
// The camera looks down, so that upright edges lean outward in its picture: a column beside an
// object's foot may cross its top, which would be taken for an obstacle far behind it.
std::vector<FloorColumn> FloorObstacles(const cv::Mat& not_floor,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF,
                                        const FloorObstacleOptions& options);

// The same of one direction whose floor was seen from one pixel to another; nothing where these do
// not look at floor within the range.
std::optional<FloorColumn> FloorBetween(const Eigen::Vector2d& begin_px,
                                        const Eigen::Vector2d& end_px, bool obstacle,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_RF, double max_range_m);

}  // namespace geon::navigation
