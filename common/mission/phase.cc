#include "mission/phase.h"

#include <cmath>

#include "active_vision/center_target.h"
#include "active_vision/turn_head.h"

namespace geon::mission {

namespace {

constexpr double kGaze_m = 2.0;

Eigen::Vector3d GazeThrough(const Context& context, const geometry::RigidTransform& X_WR,
                            const active_vision::HeadAngles& head, const Eigen::Vector3d& ray_C) {
  const geometry::RigidTransform X_WC =
      X_WR * context.rig.ColorCameraPose(head.pan_rad, head.tilt_rad);
  return X_WC * (kGaze_m * ray_C.normalized());
}

}  // namespace

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

Eigen::Vector3d GazeAt(const Context& context, const geometry::RigidTransform& X_WR,
                       const active_vision::HeadAngles& head) {
  return GazeThrough(context, X_WR, head, Eigen::Vector3d::UnitZ());
}

Eigen::Vector3d GazeAtTarget(const Context& context, const HeadSighting& sighting) {
  const auto step =
      active_vision::CenterTarget(context.rig, sighting.seen.target->box, sighting.head,
                                  context.senses.head_limits(), context.options.looking.centering);
  if (step.outcome == active_vision::Centering::kTurn) {
    return GazeAt(context, sighting.X_WR, step.head);
  }
  if (sighting.still) return GazeAt(context, sighting.X_WR, sighting.head);
  const sensor::PixelBox& box = sighting.seen.target->box;
  return GazeThrough(
      context, sighting.X_WR, sighting.head,
      context.rig.color_camera.Ray(box.u_px + 0.5 * box.w_px, box.v_px + 0.5 * box.h_px));
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
