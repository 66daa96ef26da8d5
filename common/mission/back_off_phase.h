#pragma once

#include "mission/phase.h"

namespace geon::mission {

// Moves a little along the heading, slowly and watching what is there: back from a target too large
// for the picture (thesis 4.2.2) or too near, away from a contact. Then looks again, or searches
// when the target's place is not known.
class BackOffPhase {
 public:
  void Enter(Context* context, double direction);
  Transition Step(Context* context);

 private:
  double direction_ = -1.0;
  double since_s_ = 0.0;
  Eigen::Vector2d from_W_m_ = Eigen::Vector2d::Zero();
};

}  // namespace geon::mission
