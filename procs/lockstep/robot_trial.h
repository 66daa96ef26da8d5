#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mission/phase.h"
#include "procs/lockstep/lockstep_settings.h"
#include "procs/lockstep/run_watch.h"
#include "procs/recognizer/stripe_calibration.h"
#include "sensor/geon_finding.h"
#include "sensor/geon_verdict.h"
#include "sensor/image.h"
#include "sensor/planner_state.h"
#include "sim/world.h"

namespace geon::lockstep {

// A moment of a run at which the mission went over to another phase.
struct FilmFrame {
  double time_s = 0.0;
  mission::Phase phase = mission::Phase::kWait;  // that begins
  std::string text;                              // why, in the mission's words
  Eigen::Vector2d place_W_m{0.0, 0.0};           // of the robot, in the pen
  // Of the head's camera (kBgr8): the newest then, or the first after it. Empty: it showed no other
  // than the frame before has.
  sensor::Image image;
};

// A film keeps so many frames: the first ones and the last.
inline constexpr size_t kMostFilmFrames = 12;

// What came of a mission. Times are virtual, from the start of the run.
struct RobotOutcome {
  sensor::MissionOutcome end = sensor::MissionOutcome::kRunning;  // still: time was over
  std::string why;                                                // in the mission's words
  std::optional<sensor::GeonVerdict> verdict;  // not decided: a guess, and the mission failed
  double end_s = 0.0;
  RunTrack track;
  // Where the geon stands that the mission was after, as it believed: in the pen. Nothing: it knew
  // of none.
  std::optional<Eigen::Vector2d> target_W_m;
  std::vector<sensor::GeonFinding> findings;  // places in the pen
  // The picture on which the last decision was taken (kBgr8), and the target's mask in it.
  sensor::Image view;
  std::vector<uint8_t> mask;
  std::vector<FilmFrame> film;
};

// A whole mission as section 6.3 of the thesis has it, by all daemons in lock-step with the
// simulated devices and rendered pictures: as scripts/demo runs it on the same world and seed, but
// that no machine's load delays a message. It ends with the mission, or after `longest_s`. Without
// a calibration, distances come from the rig. Errors: a mesh that cannot be used.
Result<RobotOutcome> RunRobotTrial(const LockstepSettings& settings,
                                   const std::optional<recognizer::StripeCalibration>& calibration,
                                   const sim::World& world, uint64_t seed, double longest_s);

}  // namespace geon::lockstep
