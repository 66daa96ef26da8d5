#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/sensor_rig.h"
#include "mission/drive.h"
#include "mission/head.h"
#include "mission/map_drive.h"
#include "mission/mission_options.h"
#include "mission/senses.h"
#include "mission/target_track.h"
#include "mission/target_views.h"
#include "navigation/view_coverage.h"
#include "sensor/geon_finding.h"
#include "sensor/geon_verdict.h"
#include "sensor/planner_state.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"
#include "sensor/target_mask.h"

namespace geon::mission {

// What the robot is about. `docs/channels.md` shows these names in PLANNER_STATE.
enum class Phase { kWait, kTravel, kSearch, kApproach, kCentre, kBackOff, kScan, kDone };
std::string_view ToString(Phase phase);

// A picture that a decision was taken on, for people to see what the robot saw.
struct Decision {
  HeadSighting sighting;
  int64_t scan_id = 0;  // 0: not for a scan
};

// What one step of the mission wants sent. Everything is desired state: what is absent is not
// changed.
struct Wishes {
  navigation::DriveVelocity velocity;
  std::optional<sensor::PtuCommand> head;
  std::optional<sensor::ScanPlan> scan_plan;
  std::optional<sensor::TargetMask> target_mask;  // of the same scan
  std::optional<sensor::ScanCommand> scan_command;
  std::optional<Decision> decision;
};

// Patience that is used up over a whole mission.
struct Counters {
  int scans = 0;
  int back_offs = 0;
  int traps = 0;
  int bumps = 0;
  int losses = 0;  // times the target's colour was lost close by
};

// What the phases share.
struct Context {
  const MissionOptions& options;
  const geometry::SensorRig& rig;
  Senses senses;
  Head head;
  Drive drive;
  MapDrive map_drive;
  TargetTrack target;
  navigation::ViewCoverage coverage;           // what was looked at in vain; of the planner `map`
  TargetViews views;                           // of the present target
  std::optional<double> side_rad;              // of it, that is to be looked at next
  std::optional<Eigen::Vector2d> scanned_W_m;  // where it stands, by the last scan
  std::vector<sensor::GeonFinding> findings;
  std::vector<Eigen::Vector3d> ignored_W_m;  // where targets stand that are done with
  Counters counters;
  int64_t next_scan_id = 1;

  // Seconds that the mission could work: stand still while a device it needs is away.
  double time_s = 0.0;
  // How far before the target to stop: as configured, and farther by every step back from this
  // target.
  double stop_distance_m = 0.0;
  // The target wholly in view, as the scan needs it; set by the centring.
  std::optional<HeadSighting> view;
  // Arrived since the last step.
  std::vector<sensor::RangeProfile> profiles;
  std::vector<sensor::GeonVerdict> verdicts;

  Wishes wishes;     // of this step
  std::string text;  // what is being done, for people
  int64_t scan_id = 0;
  int32_t stripe_index = 0;
  bool arrived = false;  // at the destination, where there is one
};

// How a phase ends.
struct Next {
  Phase phase = Phase::kDone;
  std::string why;
  // For kDone: the verdict, or nothing when the mission failed.
  std::optional<sensor::GeonVerdict> verdict = {};
  // For kSearch: around where the target was lost.
  bool near = false;
  // For kBackOff: which way (+1 ahead, -1 back).
  double direction = -1.0;
  // For kDone without a decided verdict.
  sensor::MissionOutcome outcome = sensor::MissionOutcome::kFailed;
};
using Transition = std::optional<Next>;

// Half the height of a geon, roughly: where to aim above a support.
inline constexpr double kTargetMiddle_m = 0.12;

// Where the target's foot is, seen from the robot's axis (frame R, horizontal).
Eigen::Vector2d InRobot(const Context& context, const Eigen::Vector2d& p_W_m);
// Head angles that look at a point of the room at a height, within the head's limits.
std::optional<active_vision::HeadAngles> AimAt(const Context& context, const Eigen::Vector2d& p_W_m,
                                               double height_m);
// A point in the middle of what the head's camera sees at these angles, some metres away (frame W).
Eigen::Vector3d GazeAt(const Context& context, const geometry::RigidTransform& X_WR,
                       const active_vision::HeadAngles& head);
// Where the whole target of a picture is to be looked for (frame W): where the centring asks for
// when an edge cuts it off (thesis 4.2.2); its middle when the head was turning; else there.
Eigen::Vector3d GazeAtTarget(const Context& context, const HeadSighting& sighting);
// Whether two looks are the same, but for the PTU's resolution.
bool Same(const active_vision::HeadAngles& a, const active_vision::HeadAngles& b);
// Steps back, and stops that much farther from the target from now on, when patience allows; else
// fails with `why`.
Next StepBack(Context* context, const std::string& why);

}  // namespace geon::mission
