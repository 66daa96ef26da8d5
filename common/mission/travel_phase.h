#pragma once

#include "mission/phase.h"
#include "mission/rule_drive.h"

namespace geon::mission {

// Drives to the destination (MissionOptions::destination_W_m), whatever is seen on the way: with
// the planner `map` by MapDrive, with `thesis` by the vertex rule as toward a target. Ends there
// with the search for a geon, or with the reason why it cannot be reached.
class TravelPhase {
 public:
  void Enter(Context* context);
  Transition Step(Context* context);

 private:
  RuleDrive rule_drive_;
  int odometry_epoch_ = 0;
};

}  // namespace geon::mission
