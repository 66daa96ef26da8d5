#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "active_vision/head_angles.h"
#include "geometry/sensor_rig.h"
#include "mission/eyes.h"
#include "mission/mission_options.h"
#include "mission/pose_history.h"
#include "navigation/map_localizer.h"
#include "navigation/obstacle_memory.h"
#include "navigation/occupancy_grid.h"
#include "sensor/base.h"
#include "sensor/geon_verdict.h"
#include "sensor/laser_state.h"
#include "sensor/ptu.h"
#include "sensor/scan_set.h"

namespace geon::mission {

// Everything the mission knows of robot and room, from the newest messages. Times are the planner's
// own seconds (arrival), for ages only; what was measured when is told by the messages' own stamps.
class Senses {
 public:
  Senses(const MissionOptions& options, const geometry::SensorRig& rig);

  void Take(double now_s, const sensor::BaseState& state);
  void Take(double now_s, const sensor::SonarScan& scan);
  void Take(double now_s, const sensor::BumperState& bumpers);
  void Take(double now_s, const sensor::InfraredScan& infrared);
  void Take(double now_s, const sensor::PtuState& state);
  void Take(double now_s, const sensor::LaserState& state);
  // With what is seen in the picture, where somebody else has looked at it already (Eyes).
  void TakeHeadImage(double now_s, sensor::Image image,
                     std::optional<attention::TargetSighting> seen = {});
  void TakeFloorImage(double now_s, sensor::Image image, std::optional<FloorSighting> seen = {});

  // Which targets are meant from now on.
  void SetFocus(Focus focus) { eyes_.SetFocus(std::move(focus)); }
  const Focus& focus() const { return eyes_.focus(); }

  // Looks at the pictures whose poses have become known; the sightings below last until the next
  // call.
  void Look(double now_s);
  const std::optional<HeadSighting>& head() const { return head_; }
  const std::optional<FloorSighting>& floor() const { return floor_; }

  // States; meaningful while the matching *Lost() is false.
  // The base's pose is in W: as odometry has it, corrected by the map.
  const sensor::BaseState& base() const { return base_; }
  const sensor::PtuState& ptu() const { return ptu_; }
  active_vision::HeadLimits head_limits() const;
  bool BaseLost(double now_s) const;
  bool PtuLost(double now_s) const;
  bool StripeCameraLost(double now_s) const;
  // No picture for some seconds (pictures are rarer than states).
  bool HeadCameraLost(double now_s) const;
  bool FloorCameraLost(double now_s) const;

  // Bearing (frame R) of a contact that is there now; nothing otherwise.
  std::optional<double> Contact() const;
  geometry::RigidTransform X_WR() const;
  // What stands around the robot, frame R.
  const std::vector<Eigen::Vector2d>& obstacles_R_m() const { return obstacles_R_m_; }
  // The map that they come from; nullptr with the planner `thesis`, which only remembers points.
  const navigation::OccupancyGrid* map() const { return map_ ? &*map_ : nullptr; }
  // Forgets what may have been a mistake.
  void ForgetDoubtfulObstacles();
  // For some time does without obstacles that may be a lamp's image in the floor; whether there are
  // any (OccupancyGrid::DoubtBright).
  bool DoubtBrightObstacles(double now_s);
  // Seconds since a floor picture was last looked at: nobody drives on old pictures.
  double floor_age_s(double now_s) const { return now_s - floor_looked_s_; }
  // What sonar and infrared heard of late; nothing before the whole sonar ring was heard, or
  // without them.
  std::optional<navigation::RingEchoes> Echoes(double now_s) const;
  bool floor_learned() const { return eyes_.floor_learned(); }
  // Grows when odometry started anew: places in W that were remembered before mean nothing.
  int odometry_epoch() const { return odometry_epoch_; }

 private:
  bool Fresh(double at_s, double now_s) const { return now_s - at_s <= patience_.stale_s; }
  void Feel(double now_s, std::span<const Eigen::Vector2d> points_R_m);
  // What else was told before odometry jumped is forgotten.
  void NoticeOdometryJump(const sensor::BaseState& next);
  // Corrects odometry, and where the picture was taken, by how a floor picture lies on the map.
  void Localize(FloorSighting* floor);

  PatienceOptions patience_;
  navigation::RingOptions rings_;
  Eigen::Vector3d p_RF_m_;  // the floor camera
  double body_radius_m_;
  PoseHistory history_;
  Eyes eyes_;
  navigation::ObstacleMemory memory_;             // of the planner `thesis`
  std::optional<navigation::OccupancyGrid> map_;  // of the planner `map`
  navigation::MapLocalizer localizer_;            // the same; else W is O
  std::optional<HeadSighting> head_;
  std::optional<FloorSighting> floor_;
  sensor::BaseState odometry_;  // as it came
  sensor::BaseState base_;      // the same in W
  sensor::PtuState ptu_;
  sensor::BumperState bumpers_;
  double base_at_s_ = -1e9;
  double ptu_at_s_ = -1e9;
  double laser_at_s_ = -1e9;
  double head_at_s_ = -1e9;
  double floor_at_s_ = -1e9;
  double floor_looked_s_ = -1e9;
  std::optional<double> heard_s_;            // the first sonar scan
  std::vector<Eigen::Vector2d> echoes_R_m_;  // of the newest one
  std::vector<Eigen::Vector2d> felt_R_m_;    // of the newest infrared scan
  sensor::DeviceStatus laser_status_ = sensor::DeviceStatus::kUnknown;
  std::vector<Eigen::Vector2d> obstacles_R_m_;
  int odometry_epoch_ = 0;
};

}  // namespace geon::mission
