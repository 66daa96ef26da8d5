#pragma once

#include <optional>

#include "mission/phase.h"

namespace geon::mission {

// Moves a little along the heading, slowly and watching what is there: back from a target too large
// for the picture (thesis 4.2.2) or too near, away from a contact. Where the way is blocked and a
// bumper stays pressed, the robot turns its back to what it touches and moves ahead: round as it
// is, it can turn. Then looks again, or searches when the target's place is not known.
class BackOffPhase {
 public:
  void Enter(Context* context, double direction);
  Transition Step(Context* context);

 private:
  void Start(const Context& context, double direction);
  void TurnAway(Context* context);

  double direction_ = -1.0;
  double since_s_ = 0.0;
  std::optional<double> away_W_rad_;  // heading that it turns to
  bool turned_ = false;
  Eigen::Vector2d from_W_m_ = Eigen::Vector2d::Zero();
};

}  // namespace geon::mission
