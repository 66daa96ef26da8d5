#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "navigation/occupancy_grid.h"

namespace geon::navigation {

// How far one sees over the ground from a place of W along a direction (of length 1) until an
// obstacle of the map stands within a cell of the ray; `farthest_m` where none does.
double FreeSight(const OccupancyGrid& map, const Eigen::Vector2d& from_W_m,
                 const Eigen::Vector2d& direction_W, double farthest_m);

// Which places of the room a camera has looked at: on each plane that can carry a target (the
// floor, desks of known heights) the places where one would have been in the picture.
//
// Source: coverage of a search as in Shermer, "Recent results in art galleries" (1992); the planes
// are those of thesis section 6.3.
// The map does not know how high obstacles are. So the floor is kept twice: as hidden by every
// obstacle before it, which is what counts in the end; and as seen over them, which is worth a
// look. What stands on a desk is seen over them. The map does not move with the robot; it must be
// cleared when odometry starts anew.
class ViewCoverage {
 public:
  // Heights of the supports above the floor; the floor itself (0) need not be among them.
  explicit ViewCoverage(const std::vector<double>& support_heights_m, double reach_m = 12.0);

  static constexpr double kCell_m = 0.10;
  static constexpr double kMiddle_m = 0.10;  // of a target, above its support

  struct Plane {
    double height_m = 0.0;
    bool over_obstacles = false;
  };
  static constexpr size_t kFloor = 0;  // in `planes`
  static constexpr size_t kFloorOverObstacles = 1;
  const std::vector<Plane>& planes() const { return planes_; }

  // One picture in which no target was seen. A target is noticed up to `farthest_m` away.
  void Look(const geometry::PinholeCamera& camera, const geometry::RigidTransform& X_WC,
            double farthest_m, const OccupancyGrid& map);
  // Takes a place for looked at. Off the map nothing happens.
  void Mark(size_t plane, const Eigen::Vector2d& p_W_m);
  // Off the map everything counts as looked at: nobody shall go there.
  bool IsLooked(size_t plane, const Eigen::Vector2d& p_W_m) const;
  void Clear();

 private:
  int Index(const Eigen::Vector2d& p_W_m) const;  // -1 off the map

  std::vector<Plane> planes_;
  int half_;                     // cells from the origin to a side
  std::vector<uint8_t> looked_;  // a bit for each plane
};

}  // namespace geon::navigation
