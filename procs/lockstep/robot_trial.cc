#include "procs/lockstep/robot_trial.h"

#include <memory>
#include <utility>

#include "geometry/rigid_transform.h"
#include "procs/lockstep/lockstep_robot.h"

namespace geon::lockstep {
namespace {

// Takes a frame whenever the mission goes over to another phase.
class Film {
 public:
  void See(const LockstepRobot& robot) {
    if (robot.mission().phase() != phase_) {
      phase_ = robot.mission().phase();
      const sim::RobotTruth truth = robot.truth();
      if (frames_.size() == kMostFilmFrames) frames_.pop_back();
      frames_.push_back(
          {robot.time_s(), phase_, robot.mission().State().text, {truth.x_m, truth.y_m}, {}});
    }
    const sensor::Image& image = robot.head_image();
    if (frames_.empty() || image.seq == newest_seq_ || !frames_.back().image.data.empty()) return;
    frames_.back().image = image;
    newest_seq_ = image.seq;
  }
  std::vector<FilmFrame> Take() { return std::move(frames_); }

 private:
  mission::Phase phase_ = mission::Phase::kWait;
  int32_t newest_seq_ = 0;  // of a picture that a frame has
  std::vector<FilmFrame> frames_;
};

// From odometry, which starts where the robot is switched on.
Eigen::Vector2d InPen(const sim::World& world, const Eigen::Vector2d& p_m) {
  return geometry::OnGround(
      geometry::PlanarPose(world.robot_x_m, world.robot_y_m, world.robot_heading_rad), p_m);
}

}  // namespace

Result<RobotOutcome> RunRobotTrial(const LockstepSettings& settings,
                                   const std::optional<recognizer::StripeCalibration>& calibration,
                                   const sim::World& world, uint64_t seed, double longest_s) {
  auto created = LockstepRobot::Create(settings, calibration, world, seed);
  if (!created.ok()) return created.status();
  LockstepRobot& robot = **created;
  const mission::Mission& mission = robot.mission();
  RunWatch watch;
  Film film;
  while (mission.outcome() == sensor::MissionOutcome::kRunning && robot.time_s() < longest_s) {
    robot.Turn();
    watch.See(robot);
    film.See(robot);
  }
  RobotOutcome outcome;
  const sensor::PlannerState state = mission.State();
  outcome.end = mission.outcome();
  outcome.why = state.text;
  outcome.verdict = mission.verdict();
  outcome.end_s = robot.time_s();
  outcome.track = watch.track();
  if (state.p_WTarget_m) outcome.target_W_m = InPen(world, *state.p_WTarget_m);
  for (sensor::GeonFinding finding : state.findings) {
    finding.p_W_m = InPen(world, finding.p_W_m);
    outcome.findings.push_back(std::move(finding));
  }
  if (robot.decision()) {
    outcome.view = robot.decision()->sighting.image;
    outcome.mask = robot.decision()->sighting.seen.mask;
  }
  outcome.film = film.Take();
  return outcome;
}

}  // namespace geon::lockstep
