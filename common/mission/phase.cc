#include "mission/phase.h"

#include <cmath>

#include "active_vision/turn_head.h"

namespace geon::mission {

std::string_view ToString(Phase phase) {
  switch (phase) {
    case Phase::kWait:
      return "wait";
    case Phase::kTravel:
      return "travel";
    case Phase::kSearch:
      return "search";
    case Phase::kApproach:
      return "approach";
    case Phase::kCentre:
      return "centre";
    case Phase::kBackOff:
      return "back_off";
    case Phase::kScan:
      return "scan";
    case Phase::kDone:
      return "done";
  }
  return "";
}

Eigen::Vector2d InRobot(const Context& context, const Eigen::Vector2d& p_W_m) {
  return geometry::OnGround(context.senses.X_WR().inverse(), p_W_m);
}

std::optional<active_vision::HeadAngles> AimAt(const Context& context, const Eigen::Vector2d& p_W_m,
                                               double height_m) {
  const Eigen::Vector3d p_P_m = context.rig.X_RP.inverse() * context.senses.X_WR().inverse() *
                                Eigen::Vector3d(p_W_m.x(), p_W_m.y(), height_m);
  const Eigen::Vector2d bearing(p_P_m.x(), p_P_m.y());
  const active_vision::HeadAngles start{std::atan2(bearing.y(), bearing.x()), 0.0};
  const auto aimed = active_vision::AimCamera(p_P_m, context.rig.X_TC, start);
  if (!aimed) return std::nullopt;
  return context.senses.head_limits().Clamp(*aimed);
}

bool Same(const active_vision::HeadAngles& a, const active_vision::HeadAngles& b) {
  constexpr double kSameLook_rad = 0.01;
  return std::abs(a.pan_rad - b.pan_rad) < kSameLook_rad &&
         std::abs(a.tilt_rad - b.tilt_rad) < kSameLook_rad;
}

Next StepBack(Context* context, const std::string& why) {
  if (context->counters.back_offs++ >= context->options.patience.back_offs) {
    return {Phase::kDone, why + ", and stepping back did not help"};
  }
  context->stop_distance_m += context->options.driving.back_off_m;
  return {Phase::kBackOff, why};
}

}  // namespace geon::mission
