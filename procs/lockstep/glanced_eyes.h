#pragma once

#include <optional>

#include "mission/eyes.h"
#include "mission/mission_options.h"
#include "sim/glance.h"
#include "sim/simulated_robot.h"

namespace geon::lockstep {

// What the mission's eyes would make of a camera's pictures, without pictures: by the simulator's
// glances. For experiments that are about driving.
class GlancedEyes {
 public:
  GlancedEyes(sim::Glancer glancer, const geometry::SensorRig& rig,
              const mission::SeeingOptions& options);

  attention::TargetSighting Head(const sim::Exposure& exposure);
  mission::FloorSighting Floor(const sim::Exposure& exposure);
  // As Floor, but nothing is hidden by the camera's view, and nothing is off: all round to
  // `farthest_m`, of what stands on the floor.
  mission::FloorSighting FloorAllRound(const sim::Exposure& exposure, double farthest_m);

 private:
  sim::Glancer glancer_;
  geometry::SensorRig rig_;
  mission::SeeingOptions options_;
};

}  // namespace geon::lockstep
