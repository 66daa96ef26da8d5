#pragma once

#include "mission/phase.h"

namespace geon::mission {

// Drives to about 90 cm before the target (thesis 4.3), the head kept on it, both cameras telling
// where it is. With the planner `thesis`, trapped (no nearer for some seconds): wanders a little
// and tries again; its rule needs that in a few pens of a hundred. With `map`, see MapDrive. Ends
// facing the target, standing still, or with the reason why it cannot be reached.
class ApproachPhase {
 public:
  void Enter(Context* context);
  Transition Step(Context* context);

 private:
  void See(Context* context);
  void KeepHeadOn(Context* context, const SupportHypothesis& target);
  Transition Arrive(Context* context, const Eigen::Vector2d& target_R_m);
  Transition DriveByMap(Context* context, const SupportHypothesis& target);
  Transition DriveByRule(Context* context, const SupportHypothesis& target);
  Transition GuardProgress(Context* context, double distance_m);

  int odometry_epoch_ = 0;
  double seen_s_ = 0.0;
  int floor_looks_ = 0;
  bool arriving_ = false;  // near enough, and turning to the target
  double nearest_m_ = 0.0;
  double nearer_s_ = 0.0;
  double wander_until_s_ = -1.0;
};

}  // namespace geon::mission
