#include "mission/rule_drive.h"

#include <limits>

namespace geon::mission {

void RuleDrive::Enter(Context* context) {
  context->drive.Rest();
  nearest_m_ = std::numeric_limits<double>::infinity();
  nearer_s_ = context->time_s;
  wander_until_s_ = -1.0;
}

Transition RuleDrive::Toward(Context* context, const Eigen::Vector2d& p_W_m,
                             double stop_distance_m) {
  if (context->time_s < wander_until_s_) {
    context->text = "trapped, wandering to find another way";
    context->wishes.velocity = context->drive.Wander(context->time_s, context->senses);
    nearest_m_ = std::numeric_limits<double>::infinity();
    nearer_s_ = context->time_s;
    return std::nullopt;
  }
  context->wishes.velocity =
      context->drive.Toward(context->time_s, context->senses, p_W_m, stop_distance_m);
  const auto& driving = context->options.driving;
  const double distance_m = InRobot(*context, p_W_m).norm();
  if (distance_m < nearest_m_ - driving.progress_m) {
    nearest_m_ = distance_m;
    nearer_s_ = context->time_s;
  }
  if (context->time_s - nearer_s_ <= driving.progress_s) return std::nullopt;
  if (context->counters.traps++ >= context->options.patience.traps) {
    return Next{Phase::kDone, "trapped: no way to the target was found"};
  }
  wander_until_s_ = context->time_s + driving.wander_s;
  context->drive.Rest();
  return std::nullopt;
}

}  // namespace geon::mission
