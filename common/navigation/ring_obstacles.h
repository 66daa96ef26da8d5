#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sensor/base.h"

namespace geon::navigation {

struct RingOptions {
  double sonar_radius_m = 0.225;  // of the sonar ring
  double sonar_min_m = 0.44;      // thesis section 3.4: nearer than this, a later echo is reported
  double sonar_max_m = 2.0;       // farther readings say nothing about where to go next
  double infrared_radius_m = 0.267;  // the infrared sensors sit in the skin
  double infrared_reach_m = 0.60;    // where the level falls to 0
  int infrared_min_level = 4;        // weaker is noise or the floor

  bool IsValid(std::string* error) const;
};

// The points of R that echoed, one per sensor that heard something: on the sensor's axis, though
// the true place may be anywhere on an arc of about +-12.5 degrees.
//
// Source: thesis section 4.3 (sonar as obstacle detector) and 3.4 (44 cm to 6.5 m).
// NaN (no echo) and readings beyond `sonar_max_m` give no point. A reading at or below the blanking
// distance gives a point at that distance: something is there or nearer.
std::vector<Eigen::Vector2d> SonarObstacles(const sensor::SonarScan& scan,
                                            const RingOptions& options);

// The same for the infrared ring, which covers what is too near for the sonar. The level grows as
// things come near, the faster the nearer, and the more the brighter they are: distances are those
// of something white, and too long for anything darker.
std::vector<Eigen::Vector2d> InfraredObstacles(const sensor::InfraredScan& scan,
                                               const RingOptions& options);

}  // namespace geon::navigation
