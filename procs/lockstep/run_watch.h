#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sim/simulated_robot.h"

namespace geon::lockstep {

class LockstepRobot;

// What a run looks like from outside, to judge it by.
struct RunTrack {
  std::optional<double> first_sight_s;    // of the geon by the head's camera or the floor's
  int contacts = 0;                       // times the body came to touch something
  double hardest_contact_m_s = 0.0;       // how fast it then drove
  double path_m = 0.0;                    // driven, first sight or not
  std::vector<Eigen::Vector2d> path_W_m;  // of the pen, a place every 0.2 s
};

// Follows a run by how things really are, turn by turn.
class RunWatch {
 public:
  // To be told after every turn.
  void See(const LockstepRobot& robot);
  // `sighted`: the mission has seen its target and still works.
  void See(double time_s, bool sighted, const sim::RobotTruth& truth);

  const RunTrack& track() const { return track_; }

 private:
  RunTrack track_;
  bool touched_ = false;
  double speed_m_s_ = 0.0;
};

}  // namespace geon::lockstep
