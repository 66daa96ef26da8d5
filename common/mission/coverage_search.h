#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "mission/phase.h"
#include "navigation/clearance_field.h"
#include "navigation/cost_to_go.h"
#include "navigation/next_view.h"

namespace geon::mission {

// Looks for a target wherever one could stand: from the place where most can be looked at per
// second (next_view.h) the robot turns the head or itself over what no picture showed yet, and goes
// on to the next place. Ends when nothing is left that could be seen from where the robot can go.
// Of the planner `map`.
class CoverageSearch {
 public:
  // What was looked at is kept in the context; which places could not be reached is forgotten.
  void Enter();
  // Nothing to say as long as there is something to look at; then the mission's end.
  Transition Step(Context* context);

 private:
  enum class Leg { kChoose, kDrive, kLook };
  // How to look over an arc: by the head alone, or by turning the robot, the head straight ahead.
  struct Look {
    double elevation_rad = 0.0;
    bool by_head = false;
    double from_W_rad = 0.0;  // of the gaze
    double over_rad = 0.0;    // signed: to the left is positive
    double area_m2 = 0.0;
    std::vector<navigation::Unlooked> unlooked;
  };

  navigation::NextViewOptions ViewOptions(const Context& context) const;
  void WeighDrives(const Context& context);
  std::optional<navigation::NextPlace> BestPlace(const Context& context);
  bool IsStillWorthIt(const Context& context);
  Transition Choose(Context* context);
  void Drive(Context* context);
  void StopDriving(Context* context);
  void StartLook(Context* context, std::vector<navigation::Unlooked> unlooked);
  void StepLook(Context* context);
  void TurnHead(Context* context);
  void TurnRobot(Context* context);
  void EndLook(Context* context);

  Leg leg_ = Leg::kChoose;
  navigation::NextPlace place_;
  navigation::ClearanceField clearance_;
  std::optional<navigation::CostToGo> drive_;  // to where the robot was, over clearance_
  std::vector<Eigen::Vector2d> given_up_W_m_;  // places that no way led to
  double leg_s_ = 0.0;                         // since when
  double weighed_s_ = 0.0;
  Look look_;
  Eigen::Vector2d looked_W_m_ = Eigen::Vector2d::Zero();  // from where the last look was
  int looks_here_ = 0;
  bool drove_ = false;
  bool at_start_ = false;    // of the arc
  double turned_rad_ = 0.0;  // along it
  double last_heading_rad_ = 0.0;
};

}  // namespace geon::mission
