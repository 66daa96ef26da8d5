#pragma once

#include <Eigen/Core>
#include <optional>
#include <random>

#include "geometry/convex_polygon.h"
#include "geometry/rigid_transform.h"
#include "navigation/cost_to_go.h"

namespace geon::navigation {

// Where to move next so as to come within `stop_distance_m` of a target.
//
// Source: thesis section 4.3, figure 4.17: the vertex of the safe polygon that is closest to the
// target. A target behind a line is approached through the vertices; one whose stopping place lies
// inside the polygon is approached straight, since every straight move inside the polygon is safe
// (the thesis does not say what happens then). Known limit, kept: the rule can be trapped
// (reference rate 2 % of pens with one box, 26 % with a U).
//
// Frame R, metres. `polygon` contains the origin. The robot's own place is the answer when it is
// within the stopping distance already.
Eigen::Vector2d WaypointToTarget(const geometry::ConvexPolygon& polygon,
                                 const Eigen::Vector2d& target_R_m, double stop_distance_m);

// Where to go when there is no target: "the robot wanders in the environment until the geon is
// detected" (thesis section 4.3). A random vertex of the safe polygon at least `min_move_m` away,
// or no answer when the polygon has none. Frame R.
std::optional<Eigen::Vector2d> WanderWaypoint(const geometry::ConvexPolygon& polygon,
                                              double min_move_m, std::mt19937& random);

// Where to move next so that it costs least from there: of the cheapest way the farthest place
// within the safe polygon, or, where the polygon ends at once, the place on its border from which
// it costs least. Nothing where no place in the polygon is cheaper than here. Frame R.
//
// Source: ours; the thesis's polygon after its "closest vertex" (4.3), which could be trapped. The
// straight move there is safe, since the polygon is convex and free.
std::optional<Eigen::Vector2d> WaypointByCost(const geometry::ConvexPolygon& polygon,
                                              const geometry::RigidTransform& X_WR,
                                              const OccupancyGrid& grid, const CostToGo& cost);

}  // namespace geon::navigation
