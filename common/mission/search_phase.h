#pragma once

#include <vector>

#include "mission/coverage_search.h"
#include "mission/phase.h"

namespace geon::mission {

// Looks for the target. With the planner `map` wherever one could stand (coverage_search.h), ending
// without one when all was looked at. With `thesis` the head sweeps what lies before the robot row
// by row without stopping (4.2.2), going back for what no picture showed; the robot turns to the
// next sector, and after a full turn wanders a little and looks about anew (4.3). A target that was
// lost close by is first swept for there. Both cameras may find the target at any time.
//
// Ends with the head's sighting (centre it; with `map`, approach it if its place is known), or with
// two of the floor camera's (approach it).
class SearchPhase {
 public:
  void Enter(Context* context, bool near);
  Transition Step(Context* context);

 private:
  enum class Leg { kSweep, kTurn, kWander, kCover };
  // What a picture without a target showed was looked at.
  void Cover(Context* context);
  void StartCovering();
  void StartSweep(Context* context, const active_vision::SearchOptions& area);
  void Sweep(Context* context);
  void Turn(Context* context);
  void Wander(Context* context);
  void NextLeg(Context* context);

  Leg leg_ = Leg::kSweep;
  struct Look {
    active_vision::HeadAngles at;
    bool taken = false;
  };
  void TakeLooks(const HeadSighting& sighting, double time_s);
  // What to point at: the start of the row of the first look not taken, then that row's end.
  active_vision::HeadAngles Aim(const Look& first, double tilt_rad) const;

  std::vector<Look> looks_;
  active_vision::HeadAngles tolerance_;
  int sectors_ = 0;
  double leg_since_s_ = 0.0;
  double look_since_s_ = 0.0;
  double heading_W_rad_ = 0.0;
  int floor_sightings_ = 0;
  CoverageSearch coverage_;
  int odometry_epoch_ = 0;  // in which the context's coverage was made
};

}  // namespace geon::mission
