#pragma once

#include <vector>

#include "mission/phase.h"

namespace geon::mission {

// Looks for the target: the head sweeps what lies before the robot (thesis 4.2.2), the robot turns
// to the next sector, and after a full turn wanders a little and looks about anew (4.3). Both
// cameras may find the target at any time.
//
// Ends with the head's sighting (centre it), or with two of the floor camera's (approach it).
class SearchPhase {
 public:
  void Enter(Context* context, bool near);
  Transition Step(Context* context);

 private:
  enum class Leg { kSweep, kTurn, kWander };
  void StartSweep(Context* context, const active_vision::SearchOptions& area);
  void Sweep(Context* context);
  void Turn(Context* context);
  void Wander(Context* context);
  void NextLeg(Context* context);

  Leg leg_ = Leg::kSweep;
  std::vector<active_vision::HeadAngles> looks_;
  size_t look_ = 0;
  int sectors_ = 0;
  double leg_since_s_ = 0.0;
  double look_since_s_ = 0.0;
  double heading_W_rad_ = 0.0;
  int floor_sightings_ = 0;
};

}  // namespace geon::mission
