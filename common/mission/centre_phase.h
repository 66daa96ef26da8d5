#pragma once

#include <set>

#include "mission/phase.h"

namespace geon::mission {

// Turns the head, 0.75 of the angle at a time, until the whole target is in view (thesis 4.2.2),
// and measures where it stands (4.2.3). The robot stands still.
//
// Ends with a view for the scan, or: too far or not faced (approach), too large for the picture,
// out of the head's reach or too near (step back), lost (search around).
class CentrePhase {
 public:
  void Enter(Context* context);
  Transition Step(Context* context);

 private:
  // The robot still turns, or the head does: keeps the gaze on the place, or the target, that it
  // is for.
  void Follow(Context* context);
  Transition Judge(Context* context, const HeadSighting& sighting);
  // Points the head where the target would be if its support had another height; whether there is
  // one that was not tried.
  bool TryAnotherHeight(Context* context);
  Transition Centred(Context* context, const HeadSighting& sighting);

  bool following_ = false;  // until all stands still for the first time
  Eigen::Vector3d gaze_W_m_ = Eigen::Vector3d::Zero();
  int steps_ = 0;
  int lost_ = 0;
  std::set<double> tried_heights_m_;
  double pointed_s_ = 0.0;
};

}  // namespace geon::mission
