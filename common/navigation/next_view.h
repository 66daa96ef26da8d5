#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "navigation/clearance_field.h"
#include "navigation/cost_to_go.h"
#include "navigation/view_coverage.h"

namespace geon::navigation {

struct NextViewOptions {
  double camera_height_m = 1.3;  // of the camera on the head
  double lowest_rad = -1.0;      // elevations that it can be pointed at
  double highest_rad = 0.2;
  double farthest_m = 5.0;       // it notices a target so far away
  double floor_near_m = 0.4;     // the floor camera notices one on the floor from here ...
  double floor_far_m = 2.2;      // ... to here, wherever the robot faces
  double speed_m_s = 0.25;       // as it drives on the whole
  double turn_rate_rad_s = 0.7;  // while looking
  double pause_s = 1.0;          // for every place: stopping, starting
  double least_m2 = 0.12;        // less is worth no drive
  double most_m2 = 2.0;          // more counts no more: what is near comes first
  double spacing_m = 0.25;       // of the places that are weighed
  double clearance_m = 0.30;     // of a place from every obstacle
  bool over_obstacles = false;   // whether floor behind obstacles is worth a look over them

  std::optional<std::string> Validate() const;
};

// Ground, or the top of what may be a desk, that could be looked at from a place and was not yet.
struct Unlooked {
  size_t plane = 0;
  Eigen::Vector2d p_W_m = Eigen::Vector2d::Zero();
  double bearing_W_rad = 0.0;
  double elevation_rad = 0.0;  // of a target there, from the head's camera
  double area_m2 = 0.0;
  bool by_floor_camera = false;
};

// All of it, bearing by bearing. Any obstacle may be a desk: its top is to be looked at where its
// front can be seen; what it hides may be seen over it.
std::vector<Unlooked> UnlookedFrom(const Eigen::Vector2d& place_W_m, const OccupancyGrid& map,
                                   const ViewCoverage& coverage, const NextViewOptions& options);

// The shortest arc that holds all bearings: from `first_rad` over `span_rad` to the left.
struct Arc {
  double first_rad = 0.0;
  double span_rad = 0.0;
};
Arc ArcOf(std::span<const Unlooked> unlooked);

double AreaOf(std::span<const Unlooked> unlooked);

// What a place is worth, in area per second, `drive_m` away; 0 where it is worth no drive.
double Utility(std::span<const Unlooked> unlooked, double drive_m, const NextViewOptions& options);

struct NextPlace {
  Eigen::Vector2d place_W_m = Eigen::Vector2d::Zero();
  double area_m2 = 0.0;  // to be looked at from there
  double utility_m2_s = 0.0;
};

// Where to look from next: of the places that the robot can drive to, the one from which most is
// looked at per second of driving and looking. Nothing when no place is worth it: then all that can
// be seen from where the robot can go was looked at.
//
// Source: next best view by utility per cost (Gonzalez-Banos and Latombe, "Navigation strategies
// for exploring indoor environments", 2002), with what a picture covers in place of frontiers.
// `drive` leads to where the robot is, over `clearance`; places for which `is_given_up` holds are
// left out.
std::optional<NextPlace> NextPlaceToLookFrom(
    const OccupancyGrid& map, const ViewCoverage& coverage, const ClearanceField& clearance,
    const CostToGo& drive, const std::function<bool(const Eigen::Vector2d&)>& is_given_up,
    const NextViewOptions& options);

}  // namespace geon::navigation
