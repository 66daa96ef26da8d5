#include "mission/approach_phase.h"

#include <cmath>
#include <string>

#include "base/angles.h"

namespace geon::mission {

namespace {

constexpr double kOffAim_rad = 0.06;  // a third of the colour camera's half view
constexpr double kFacingTarget_rad = 0.10;
constexpr int kFloorLooks = 3;        // that may tell a desk from floor, before arriving at either
constexpr double kUnseen_s = 12.0;    // then the estimate is no longer trusted
constexpr double kOnSide_rad = 0.30;  // beside the side that is wanted, on arriving ...
constexpr double kStillOnSide_rad = 0.45;  // ... and while turning to the target
constexpr double kStillThere_m = 0.08;     // farther than on arriving
constexpr double kFootToMiddle_m = 0.08;   // of a target, roughly

// What the robot drives to: the target's foot, or, to see another side of it, its middle as
// scanned.
struct Aim {
  Eigen::Vector2d p_W_m;
  double stop_distance_m;
};
Aim AimOf(const Context& context, const SupportHypothesis& target) {
  if (!context.side_rad) return {target.p_WFoot_m, context.stop_distance_m};
  return {context.views.middle_W_m(), context.stop_distance_m + kFootToMiddle_m};
}

// Whether the robot stands on the side from which it is to look.
bool IsOnSide(const Context& context, const Eigen::Vector2d& target_W_m, double tolerance_rad) {
  if (!context.side_rad) return true;
  const Eigen::Vector2d out_m = context.senses.X_WR().translation().head<2>() - target_W_m;
  return std::abs(WrapAngle(std::atan2(out_m.y(), out_m.x()) - *context.side_rad)) < tolerance_rad;
}

std::string ApproachText(double distance_m) {
  return "approaching the target, " + std::to_string(distance_m).substr(0, 4) + " m away";
}

}  // namespace

void ApproachPhase::Enter(Context* context) {
  context->map_drive.Rest();
  context->view.reset();
  odometry_epoch_ = context->senses.odometry_epoch();
  seen_s_ = context->time_s;
  rule_drive_.Enter(context);
  floor_looks_ = 0;
  arriving_ = false;
}

Transition ApproachPhase::Step(Context* context) {
  if (context->senses.odometry_epoch() != odometry_epoch_) {
    return Next{Phase::kSearch, "odometry started anew, the target's place is not known"};
  }
  See(context);
  if (context->time_s - seen_s_ > kUnseen_s) {
    return Next{Phase::kSearch, "the target was not seen for too long"};
  }
  const SupportHypothesis* target =
      context->target.NearestLikely(context->senses.X_WR().translation().head<2>());
  if (target == nullptr) return Next{Phase::kSearch, "the target was lost"};
  KeepHeadOn(context, *target);

  const Eigen::Vector2d target_R_m = InRobot(*context, target->p_WFoot_m);
  const Aim aim = AimOf(*context, *target);
  const double there_m = aim.stop_distance_m + context->options.looking.stop_tolerance_m +
                         (arriving_ ? kStillThere_m : 0.0);
  arriving_ = InRobot(*context, aim.p_W_m).norm() <= there_m &&
              IsOnSide(*context, aim.p_W_m, arriving_ ? kStillOnSide_rad : kOnSide_rad);
  if (arriving_) return Arrive(context, target_R_m);
  if (context->options.driving.planner == PlannerKind::kMap) return DriveByMap(context, *target);
  return DriveByRule(context, *target);
}

Transition ApproachPhase::DriveByMap(Context* context, const SupportHypothesis& target) {
  MapDrive* drive = &context->map_drive;
  const double stop_m = context->stop_distance_m;
  const MapDrive::Answer answer =
      context->side_rad
          ? drive->Round(context->time_s, target.p_WFoot_m, stop_m, *context->side_rad,
                         &context->senses)
          : drive->Toward(context->time_s, target.p_WFoot_m, stop_m, &context->senses);
  context->text =
      answer.text.empty() ? ApproachText(InRobot(*context, target.p_WFoot_m).norm()) : answer.text;
  context->wishes.velocity = answer.velocity;
  if (answer.unreachable) {
    Next end{Phase::kDone, *answer.unreachable};
    end.outcome = sensor::MissionOutcome::kUnreachable;
    return end;
  }
  return std::nullopt;
}

Transition ApproachPhase::DriveByRule(Context* context, const SupportHypothesis& target) {
  context->text = ApproachText(InRobot(*context, target.p_WFoot_m).norm());
  return rule_drive_.Toward(context, target.p_WFoot_m, context->stop_distance_m);
}

void ApproachPhase::See(Context* context) {
  const auto& head = context->senses.head();
  if (head && head->seen.target) {
    context->target.See(*head);
    seen_s_ = context->time_s;
  }
  const auto& floor = context->senses.floor();
  if (floor) {
    context->target.See(*floor);
    ++floor_looks_;
    if (floor->seen.target) seen_s_ = context->time_s;
  }
}

void ApproachPhase::KeepHeadOn(Context* context, const SupportHypothesis& target) {
  const auto aim = AimAt(*context, target.p_WFoot_m, target.support_height_m + kTargetMiddle_m);
  if (aim) context->head.Keep(*aim, kOffAim_rad);
}

Transition ApproachPhase::Arrive(Context* context, const Eigen::Vector2d& target_R_m) {
  context->text = "facing the target";
  if (floor_looks_ < kFloorLooks) return std::nullopt;
  const double bearing_rad = std::atan2(target_R_m.y(), target_R_m.x());
  if (std::abs(bearing_rad) > kFacingTarget_rad) {
    context->wishes.velocity = context->drive.TurnTo(bearing_rad);
    return std::nullopt;
  }
  if (context->senses.base().moving) return std::nullopt;
  return Next{Phase::kCentre, "arrived before the target"};
}

}  // namespace geon::mission
