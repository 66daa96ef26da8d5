#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "geometry/convex_polygon.h"

namespace geon::navigation {

struct SafePolygonOptions {
  // Distance kept between an obstacle and the line drawn for it: "greater than the robot's radius"
  // (0.267 m). Larger: fewer gaps are passable; 0.75 m wide ones need less than 0.37.
  double clearance_m = 0.33;
  // Points this little nearer than an obstacle's line still belong to that obstacle: the unevenness
  // of a wall as the sensors see it. Taken off the clearance.
  double slack_m = 0.03;
  // Half the side of the default bounding box.
  double default_box_m = 3.0;

  bool IsValid(std::string* error) const;
};

// Where the robot can move in a straight line without touching anything.
//
// Source: thesis section 4.3, figures 4.15 and 4.16. For each obstacle a line perpendicular to the
// shortest distance between robot and obstacle, `clearance_m` before it, divides the plane; the
// polygon is the intersection of the admissible sides and the default bounding box.
//
// Deviations: the thesis does not say what one obstacle is when sensors deliver points. Here the
// nearest point starts an obstacle, every point behind its line (less the slack) belongs to it, and
// so on with the rest. An obstacle nearer than the clearance gets its line through the robot (a
// micrometre before its middle): only ways out remain. To it belongs what is as far as the
// clearance behind that line (less the slack), and in its own direction what is nearer.
//
// Points and polygon are in R (x forward, y left). `obstacles_R_m` is reordered; nothing is
// allocated. The polygon is convex, holds the origin inside, and keeps every point at least
// clearance - slack away (points nearer than the clearance: outside).
geometry::ConvexPolygon SafePolygon(std::span<Eigen::Vector2d> obstacles_R_m,
                                    const SafePolygonOptions& options);

}  // namespace geon::navigation
