#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/convex_polygon.h"
#include "mission/mission_options.h"
#include "mission/senses.h"
#include "mission/waypoint_follower.h"
#include "navigation/clearance_field.h"
#include "navigation/cost_to_go.h"
#include "navigation/velocity_law.h"

namespace geon::mission {

// The planner `map`: drives to where a target can be looked at, by what the map of obstacles says
// it costs from everywhere (cost_to_go.h), one straight move within the safe polygon after another
// (thesis 4.3). Ways and polygons with room for the drift of odometry are taken where there are
// any, then tighter ones; on ground that no picture showed the robot is slow. It notices when it
// comes no nearer and then tries, in this order: hear the whole sonar ring anew, forget what may
// have been a mistake, doubt what may be a lamp's image in the floor, look all round, step back.
// What none of these opens is unreachable, and why is told.
class MapDrive {
 public:
  explicit MapDrive(const MissionOptions& options);
  MapDrive(const MapDrive&) = delete;
  MapDrive& operator=(const MapDrive&) = delete;

  struct Answer {
    navigation::DriveVelocity velocity;
    std::string text;                        // what is being done, when it is not driving on
    std::optional<std::string> unreachable;  // why
  };
  // Toward a target in W, to stop at most `stop_distance_m` before it.
  Answer Toward(double now_s, const Eigen::Vector2d& p_WTarget_m, double stop_distance_m,
                Senses* senses) {
    return Drive(now_s, {p_WTarget_m, stop_distance_m, {}, true}, senses);
  }
  // Round a target to one of its sides: the bearing in W from the target to the robot. Given up
  // after the first three recoveries.
  Answer Round(double now_s, const Eigen::Vector2d& p_WTarget_m, double stop_distance_m,
               double side_rad, Senses* senses) {
    return Drive(now_s, {p_WTarget_m, stop_distance_m, side_rad}, senses);
  }
  // To a place in W. One of many, so that it is given up after the first three recoveries.
  Answer To(double now_s, const Eigen::Vector2d& p_W_m, Senses* senses) {
    return Drive(now_s, {p_W_m, 0.0, {}}, senses);
  }
  // To the one place in W that the robot was sent to: everything is tried.
  Answer ToDestination(double now_s, const Eigen::Vector2d& p_W_m, Senses* senses) {
    return Drive(now_s, {p_W_m, 0.0, {}, true}, senses);
  }

  // Starts anew: another target, or something else took over meanwhile.
  void Rest();

  // What the last answer was made of, frame R, for people; nothing after Rest.
  const geometry::ConvexPolygon& polygon_R() const { return polygon_R_; }
  const Eigen::Vector2d& waypoint_R_m() const { return follower_.waypoint_R_m(); }

 private:
  enum class Recovery { kNone, kListen, kForget, kDoubtBright, kLookRound, kStepBack, kGiveUp };
  struct Goal {
    Eigen::Vector2d p_W_m = Eigen::Vector2d::Zero();
    double stop_distance_m = 0.0;  // 0: a place to stand at, not a target
    std::optional<double> side_rad;
    bool insists = false;  // on this one goal: looks round and steps back before giving up
  };
  Answer Drive(double now_s, const Goal& goal, Senses* senses);
  void Map(double now_s, const Senses& senses);
  std::vector<navigation::CostToGo::Goal> GoalCells(const navigation::OccupancyGrid& map) const;
  std::optional<Answer> Recover(double now_s, Senses* senses);
  std::string WhyUnreachable() const;
  void StartRecovery(double now_s, const Senses& senses);
  // Slow where the body comes upon ground that no picture showed, where obstacles were forgotten
  // and where they leave no room for being elsewhere than the map has them.
  navigation::DriveVelocity Careful(navigation::DriveVelocity velocity, const Senses& senses) const;
  bool IsUnknownAhead(const navigation::DriveVelocity& velocity, const Senses& senses) const;
  bool IsKnown(const Eigen::Vector2d& p_R_m, const Senses& senses) const;
  // Whether the cost from here fell lately; else something must be tried.
  bool Progresses(double now_s, double cost_m);

  DrivingOptions options_;
  Goal goal_;
  // Round a target no obstacle counts, they are its own and its desk's; unless the robot is to
  // drive round them.
  double own_m_ = 0.0;
  std::vector<Eigen::Vector2d> bending_R_m_;
  navigation::ClearanceField clearance_;
  // To the target: along ways with room to spare, of the clearance that is kept, and tighter ones.
  navigation::CostToGo wide_cost_, easy_cost_, tight_cost_;
  const navigation::CostToGo* cost_ = &easy_cost_;  // in use
  std::optional<Eigen::Vector2d> mapped_W_m_;       // the goal that cost_ leads to
  int64_t mapped_revision_ = -1;
  double mapped_s_ = 0.0;
  geometry::ConvexPolygon polygon_R_;
  bool squeezes_ = false;  // only a polygon without that room leads on
  WaypointFollower follower_;

  double best_cost_m_ = 0.0;
  double better_s_ = 0.0;
  bool started_ = false;
  Recovery recovery_ = Recovery::kNone;  // being tried, or tried last
  bool recovering_ = false;
  double recovery_s_ = 0.0;
  double turned_rad_ = 0.0;
  double last_heading_rad_ = 0.0;
  double recovered_cost_m_ = 0.0;  // when it began, and where
  Eigen::Vector2d recovered_W_m_ = Eigen::Vector2d::Zero();
};

}  // namespace geon::mission
