#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "active_vision/center_target.h"
#include "active_vision/place_stripes.h"
#include "active_vision/search_pattern.h"
#include "attention/color_model.h"
#include "attention/find_target.h"
#include "navigation/cost_to_go.h"
#include "navigation/floor_model.h"
#include "navigation/floor_obstacles.h"
#include "navigation/map_localizer.h"
#include "navigation/next_view.h"
#include "navigation/obstacle_memory.h"
#include "navigation/occupancy_grid.h"
#include "navigation/ring_obstacles.h"
#include "navigation/safe_polygon.h"
#include "navigation/velocity_law.h"

namespace geon::mission {

// What the robot's cameras need to know to see with.
struct SeeingOptions {
  attention::ColorModel target_color;
  attention::AttentionOptions head;
  attention::AttentionOptions floor;
  navigation::FloorModel
      floor_model;  // known a priori (thesis 4.3 (i)), refined from the first picture
  bool learn_floor = true;
  navigation::FloorObstacleOptions floor_obstacles;
  double exposure_s = 0.06;  // the head must stand still so long after utime, or for the exposure
                             // that the picture states, if that is longer
  double still_rad = 0.001;  // angles this near are the same angle

  bool IsValid(std::string* error) const;
};

// Who says where to drive: the thesis's rule (4.3), or what a map of obstacles says it costs.
enum class PlannerKind { kThesis, kMap };
std::string_view ToString(PlannerKind planner);
std::optional<PlannerKind> PlannerKindFromString(std::string_view name);

// How the robot moves.
struct DrivingOptions {
  PlannerKind planner = PlannerKind::kMap;
  navigation::SafePolygonOptions safe_polygon;
  navigation::VelocityLawOptions velocity;
  navigation::RingOptions rings;
  navigation::ObstacleMemoryOptions memory;  // of the planner `thesis`
  // Of the planner `map`: obstacles are known better, so that it may pass nearer to them.
  navigation::OccupancyGridOptions map;
  navigation::MapLocalizerOptions localizer;
  navigation::CostToGoOptions cost_to_go;
  navigation::SafePolygonOptions map_polygon{0.31, 0.02, 2.0};
  double wander_s = 7.0;  // one leg of wandering
  double wander_min_move_m = 0.6;
  double back_off_m = 0.20;  // "move backwards a little" (thesis 4.2.2)
  double back_off_speed_m_s = 0.10;
  double progress_m = 0.10;  // trapped when the target does not come this much nearer ...
  double progress_s = 6.0;   // ... within this time

  bool IsValid(std::string* error) const;
};

// How stripes are laid: the head stops for each (thesis 4.2.4), or sweeps over the target.
enum class ScanMode { kStop, kSweep };
std::string_view ToString(ScanMode mode);
std::optional<ScanMode> ScanModeFromString(std::string_view name);

// Where targets can stand and how they are looked at.
struct LookingOptions {
  std::vector<double> support_heights_m = {0.0, 0.7};  // floor, "desk of known height" (thesis 6.3)
  double stop_distance_m = 0.93;  // from the robot's axis to the target's foot: "approx. 90 cm"
  double stop_tolerance_m = 0.04;
  double min_range_m = 0.7;  // of the range finder, from the B/W camera (thesis 3.2)
  double max_range_m = 2.0;
  double max_target_distance_m = 7.0;  // a foot farther away is none
  active_vision::SearchOptions sweep{-1.05, 1.05, -0.26, 0.14, 0.5, 0.2};  // while looking about
  active_vision::SearchOptions near{-0.55, 0.55, -0.80, 0.05, 0.5, 0.2};   // for one that was lost
  navigation::NextViewOptions next_view;  // of the planner `map`; the camera's height is the rig's
  double sector_rad = 2.1;                // the robot turns by this much between sweeps
  active_vision::CenteringOptions centering;
  int centering_steps = 8;  // "several iterations" (thesis 4.2.2)
  int lost_looks = 3;       // pictures without the target before it counts as lost
  active_vision::StripePlacementOptions placement;
  double settle_s = 0.12;  // after the head stopped
  ScanMode scan = ScanMode::kStop;
  double sweep_s = 0.45;  // from the first stripe of a laser to the last, while sweeping

  bool IsValid(std::string* error) const;
};

// How long to insist.
struct PatienceOptions {
  double mission_s = 300.0;  // the whole mission; after that it has failed
  double device_s = 30.0;    // a device that does not answer for so long ends the mission
  double stale_s = 1.0;      // a state older than this says nothing
  double image_s = 3.0;      // a picture with the head standing still
  double stripe_s = 5.0;     // one stripe, from command to profile
  double verdict_s = 10.0;   // after the last profile
  int stripe_attempts = 3;   // per stripe, before the head moves on
  int min_stripes = 4;       // fewer profiles than this do not make a scan
  int scans = 4;             // scans of one target before giving up
  int views = 3;             // of a target that the verdict does not decide on; of planner `map`
  int back_offs = 4;         // steps back for a target too large or out of the head's reach
  int traps = 6;             // times the robot may get trapped on its way to the target
  int bumps = 5;             // contacts
  int losses = 4;            // times a target's colour may get lost close by

  bool IsValid(std::string* error) const;
};

struct MissionOptions {
  SeeingOptions seeing;
  DrivingOptions driving;
  LookingOptions looking;
  PatienceOptions patience;
  // Drive here first, then look for geons: in W, so that the origin is where odometry started.
  std::optional<Eigen::Vector2d> destination_W_m;
  bool inventory = false;  // name all geons, not just the first one; of planner `map`
  uint32_t seed = 1;       // of the wandering

  // States the first rule that is broken.
  bool IsValid(std::string* error) const;
};

}  // namespace geon::mission
