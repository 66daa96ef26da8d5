#include "mission/travel_phase.h"

#include <string>

namespace geon::mission {
namespace {

constexpr double kArrived_m = 0.1;
const active_vision::HeadAngles kHeadAhead{0.0, -0.1};

}  // namespace

void TravelPhase::Enter(Context* context) {
  context->map_drive.Rest();
  rule_drive_.Enter(context);
  odometry_epoch_ = context->senses.odometry_epoch();
}

Transition TravelPhase::Step(Context* context) {
  if (context->senses.odometry_epoch() != odometry_epoch_) {
    return Next{Phase::kDone, "odometry started anew: where the destination lies is not known"};
  }
  const Eigen::Vector2d& destination_W_m = *context->options.destination_W_m;
  const double distance_m = InRobot(*context, destination_W_m).norm();
  if (distance_m < kArrived_m) {
    context->arrived = true;
    return Next{Phase::kSearch, "arrived at the destination"};
  }
  context->head.Point(kHeadAhead);
  context->text =
      "driving to the destination, " + std::to_string(distance_m).substr(0, 4) + " m away";
  if (context->options.driving.planner == PlannerKind::kThesis) {
    return rule_drive_.Toward(context, destination_W_m, 0.0);
  }
  const MapDrive::Answer answer =
      context->map_drive.ToDestination(context->time_s, destination_W_m, &context->senses);
  context->wishes.velocity = answer.velocity;
  if (!answer.text.empty()) context->text = answer.text;
  if (!answer.unreachable) return std::nullopt;
  Next end{Phase::kDone, *answer.unreachable};
  end.outcome = sensor::MissionOutcome::kUnreachable;
  return end;
}

}  // namespace geon::mission
