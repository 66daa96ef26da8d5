#include "mission/back_off_phase.h"

namespace geon::mission {

namespace {

constexpr double kWayPatienceFactor_1 = 3.0;  // of the time the way takes at the slow speed
constexpr double kDone_m = 0.01;

}  // namespace

void BackOffPhase::Enter(Context* context, double direction) {
  direction_ = direction;
  since_s_ = context->time_s;
  from_W_m_ = context->senses.X_WR().translation().head<2>();
  context->drive.Rest();
}

Transition BackOffPhase::Step(Context* context) {
  context->text = direction_ < 0 ? "moving back a little" : "moving ahead a little";
  const auto& driving = context->options.driving;
  const double moved_m = (context->senses.X_WR().translation().head<2>() - from_W_m_).norm();
  const double rest_m = driving.back_off_m - moved_m;
  const double patience_s = kWayPatienceFactor_1 * driving.back_off_m / driving.back_off_speed_m_s;
  if (rest_m > kDone_m && context->time_s - since_s_ < patience_s) {
    context->wishes.velocity = context->drive.Creep(direction_, rest_m, context->senses);
    return std::nullopt;
  }
  if (context->senses.base().moving) return std::nullopt;
  if (context->options.destination_W_m && !context->arrived) {
    return Next{Phase::kTravel, "driving on to the destination"};
  }
  if (const SupportHypothesis* target = context->target.Best()) {
    if (const auto aim =
            AimAt(*context, target->p_WFoot_m, target->support_height_m + kTargetMiddle_m)) {
      context->head.Point(*aim);
      return Next{Phase::kCentre, "looking at the target again"};
    }
  }
  return Next{Phase::kSearch, "the target's place is not known"};
}

}  // namespace geon::mission
