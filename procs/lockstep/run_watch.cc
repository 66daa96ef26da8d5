#include "procs/lockstep/run_watch.h"

#include <algorithm>
#include <cmath>

#include "procs/lockstep/lockstep_robot.h"

namespace geon::lockstep {

void RunWatch::See(const LockstepRobot& robot) {
  const mission::Mission& mission = robot.mission();
  const bool sighted = mission.phase() != mission::Phase::kWait &&
                       mission.phase() != mission::Phase::kTravel &&
                       mission.phase() != mission::Phase::kSearch &&
                       mission.outcome() == sensor::MissionOutcome::kRunning;
  See(robot.time_s(), sighted, robot.truth());
}

void RunWatch::See(double time_s, bool sighted, const sim::RobotTruth& truth) {
  constexpr double kStride_s = 0.2;
  if (!track_.first_sight_s && sighted) track_.first_sight_s = time_s;
  if (truth.contacts > 0 && !touched_) {
    ++track_.contacts;
    // The speed before it: a contact stops the robot.
    track_.hardest_contact_m_s = std::max(track_.hardest_contact_m_s, std::abs(speed_m_s_));
  }
  touched_ = truth.contacts > 0;
  speed_m_s_ = truth.speed_m_s;
  track_.path_m += std::abs(speed_m_s_) * LockstepRobot::kTurn_s;
  if (time_s >= kStride_s * static_cast<double>(track_.path_W_m.size())) {
    track_.path_W_m.emplace_back(truth.x_m, truth.y_m);
  }
}

}  // namespace geon::lockstep
