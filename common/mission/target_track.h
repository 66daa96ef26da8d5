#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/rigid_transform.h"
#include "mission/eyes.h"
#include "mission/mission_options.h"

namespace geon::mission {

// Where the target stands if its support has this height.
struct SupportHypothesis {
  double support_height_m = 0.0;
  int sightings = 0;  // 0: none that this height explains
  Eigen::Vector2d p_WFoot_m = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();
  double misfit_1 = 0.0;  // sum of squared, normalised surprises; smaller is likelier
  int surprises = 0;      // in a row, that did not move the estimate
};

// Where the target is, from all sightings so far.
//
// One picture gives a ray to the target's foot (thesis 4.2.3), and so a place on the floor or one
// on the desk. From the next place the right guess stays where it was and the wrong one moves: each
// height is tracked by a small Kalman filter, whose surprises tell the heights apart. So do the two
// cameras, one 0.45 m above the other, and the floor in front of the target (what stands on a desk
// has a desk before it).
class TargetTrack {
 public:
  TargetTrack(const LookingOptions& options, const geometry::SensorRig& rig);

  void Clear();
  // Nothing happens when the picture shows no target or not its foot.
  void See(const HeadSighting& sighting);
  void See(const FloorSighting& sighting);
  // The range finder measured another height than this one, or nothing where the target would be:
  // every other height becomes likelier.
  void Refute(double support_height_m);

  bool known() const { return Best() != nullptr; }
  // The likeliest height; nullptr without one.
  const SupportHypothesis* Best() const;
  // The nearest place, seen from the robot, that the sightings do not speak against: driving there
  // is right whichever guess is.
  const SupportHypothesis* NearestLikely(const Eigen::Vector2d& p_WRobot_m) const;
  const std::vector<SupportHypothesis>& hypotheses() const { return hypotheses_; }

 private:
  void Observe(const geometry::RigidTransform& X_WC, const Eigen::Vector3d& ray_C,
               double sigma_rad);
  void RefuteDesksOverFreeFloor(const FloorSighting& sighting);

  LookingOptions options_;
  geometry::SensorRig rig_;
  std::vector<SupportHypothesis> hypotheses_;
  int surprises_ = 0;
};

}  // namespace geon::mission
