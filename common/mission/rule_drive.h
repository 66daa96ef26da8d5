#pragma once

#include <Eigen/Core>

#include "mission/phase.h"

namespace geon::mission {

// The planner `thesis` on its way to a place: the vertex rule (Drive::Toward, thesis 4.3). Trapped
// (no nearer for some seconds), it wanders a little and tries again; the rule needs that in a few
// pens of a hundred.
class RuleDrive {
 public:
  void Enter(Context* context);
  // Wishes to drive toward a place in W, to stop so far before it. Ends the mission when the robot
  // was trapped too often.
  Transition Toward(Context* context, const Eigen::Vector2d& p_W_m, double stop_distance_m);

 private:
  double nearest_m_ = 0.0;
  double nearer_s_ = 0.0;
  double wander_until_s_ = -1.0;
};

}  // namespace geon::mission
