#pragma once

#include "mission/phase.h"
#include "mission/rule_drive.h"

namespace geon::mission {

// Drives to about 90 cm before the target (thesis 4.3), the head kept on it, both cameras telling
// where it is. With the planner `thesis` see RuleDrive, with `map` MapDrive. Ends
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

  int odometry_epoch_ = 0;
  double seen_s_ = 0.0;
  int floor_looks_ = 0;
  bool arriving_ = false;  // near enough, and turning to the target
  RuleDrive rule_drive_;
};

}  // namespace geon::mission
