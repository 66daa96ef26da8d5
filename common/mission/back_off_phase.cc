#include "mission/back_off_phase.h"

#include <cmath>

#include "base/angles.h"

namespace geon::mission {

namespace {

constexpr double kWayPatienceFactor_1 = 3.0;  // of the time the way takes at the slow speed
constexpr double kDone_m = 0.01;
constexpr double kBlocked_s = 1.0;  // hardly moved since: that way does not lead away
constexpr double kTurned_rad = 0.1;
constexpr double kTurn_s = 10.0;  // at most

}  // namespace

void BackOffPhase::Enter(Context* context, double direction) {
  away_W_rad_.reset();
  turned_ = false;
  context->drive.Rest();
  Start(*context, direction);
}

void BackOffPhase::Start(const Context& context, double direction) {
  direction_ = direction;
  since_s_ = context.time_s;
  from_W_m_ = context.senses.X_WR().translation().head<2>();
}

void BackOffPhase::TurnAway(Context* context) {
  context->text = "turning away from what it touches";
  const double left_rad = WrapAngle(*away_W_rad_ - context->senses.base().heading_rad);
  context->wishes.velocity = context->drive.TurnTo(left_rad);
  if (std::abs(left_rad) < kTurned_rad || context->time_s - since_s_ > kTurn_s) {
    away_W_rad_.reset();
    Start(*context, 1.0);
  }
}

Transition BackOffPhase::Step(Context* context) {
  if (away_W_rad_) {
    TurnAway(context);
    return std::nullopt;
  }
  context->text = direction_ < 0 ? "moving back a little" : "moving ahead a little";
  const auto& driving = context->options.driving;
  const double moved_m = (context->senses.X_WR().translation().head<2>() - from_W_m_).norm();
  const auto contact_rad = context->senses.Contact();
  if (contact_rad && !turned_ && moved_m < kDone_m && context->time_s - since_s_ > kBlocked_s) {
    turned_ = true;
    since_s_ = context->time_s;
    away_W_rad_ = context->senses.base().heading_rad + *contact_rad + kPi;
    return std::nullopt;
  }
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
