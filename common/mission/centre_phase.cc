#include "mission/centre_phase.h"

#include <cmath>

#include "active_vision/ground_distance.h"
#include "mission/scan_geometry.h"

namespace geon::mission {

namespace {

constexpr double kFaced_rad = 0.35;            // beyond this the robot turns to the target first
constexpr double kNearEnough_m = 0.08;         // beyond the stopping distance
constexpr double kOffGaze_rad = 0.05;          // then the head is pointed anew
constexpr double kLookPatienceFactor_1 = 3.0;  // of image_s: head still and a picture taken

}  // namespace

void CentrePhase::Enter(Context* context) {
  context->view.reset();
  context->drive.Rest();
  steps_ = 0;
  lost_ = 0;
  tried_heights_m_.clear();
  pointed_s_ = context->time_s;
  if (!context->head.wanted()) {
    const auto& ptu = context->senses.ptu();
    context->head.Point({ptu.pan_rad, ptu.tilt_rad});
  }
  following_ = true;
  gaze_W_m_ = GazeAt(*context, context->senses.X_WR(), *context->head.wanted());
}

void CentrePhase::Follow(Context* context) {
  const auto& seen = context->senses.head();
  if (seen && seen->seen.target) gaze_W_m_ = GazeAtTarget(*context, *seen);
  const auto aim = AimAt(*context, gaze_W_m_.head<2>(), gaze_W_m_.z());
  const active_vision::HeadAngles& wanted = *context->head.wanted();
  if (aim && (std::abs(aim->pan_rad - wanted.pan_rad) > kOffGaze_rad ||
              std::abs(aim->tilt_rad - wanted.tilt_rad) > kOffGaze_rad)) {
    context->head.Point(*aim);
  }
}

Transition CentrePhase::Step(Context* context) {
  context->text = "bringing the whole target into view";
  const double patience_s = kLookPatienceFactor_1 * context->options.patience.image_s;
  if (context->time_s - pointed_s_ > patience_s) {
    return Next{Phase::kSearch, "the head did not come to rest for a picture"};
  }
  if (!context->head.Settled(context->time_s, context->senses.ptu(),
                             context->options.looking.settle_s) ||
      context->senses.base().moving) {
    if (following_) Follow(context);
    return std::nullopt;
  }
  following_ = false;
  const auto& head = context->senses.head();
  const auto& wanted = *context->head.wanted();
  if (!head || !head->still || !Same(head->head, wanted)) return std::nullopt;
  pointed_s_ = context->time_s;
  if (head->seen.target) {
    lost_ = 0;
    return Judge(context, *head);
  }
  if (++lost_ < context->options.looking.lost_looks) return std::nullopt;
  if (TryAnotherHeight(context)) return std::nullopt;
  if (context->counters.losses++ >= context->options.patience.losses) {
    return Next{Phase::kDone, "the target's colour is lost again and again"};
  }
  return Next{Phase::kSearch, "the target's colour was lost", std::nullopt, true};
}

bool CentrePhase::TryAnotherHeight(Context* context) {
  for (const SupportHypothesis& support : context->target.hypotheses()) {
    if (support.sightings == 0 || !tried_heights_m_.insert(support.support_height_m).second)
      continue;
    const auto aim = AimAt(*context, support.p_WFoot_m, support.support_height_m + kTargetMiddle_m);
    if (!aim || Same(*aim, *context->head.wanted())) continue;
    context->head.Point(*aim);
    lost_ = 0;
    return true;
  }
  return false;
}

Transition CentrePhase::Judge(Context* context, const HeadSighting& sighting) {
  const auto& looking = context->options.looking;
  const auto step =
      active_vision::CenterTarget(context->rig, sighting.seen.target->box, sighting.head,
                                  context->senses.head_limits(), looking.centering);
  switch (step.outcome) {
    case active_vision::Centering::kInView:
      return Centred(context, sighting);
    case active_vision::Centering::kTurn:
      if (++steps_ > looking.centering_steps) {
        return StepBack(context, "the target does not fit into the picture");
      }
      context->head.Point(step.head);
      return std::nullopt;
    case active_vision::Centering::kTooLarge:
      return StepBack(context, "the target is too large for the picture");
    case active_vision::Centering::kAtLimit:
      return StepBack(context, "the head cannot turn far enough");
  }
  return std::nullopt;
}

Transition CentrePhase::Centred(Context* context, const HeadSighting& sighting) {
  context->target.See(sighting);
  const SupportHypothesis* nearest =
      context->target.NearestLikely(sighting.X_WR.translation().head<2>());
  if (nearest == nullptr) {
    return Next{Phase::kSearch, "no known support explains where the target is seen"};
  }
  const Eigen::Vector2d target_R_m = InRobot(*context, nearest->p_WFoot_m);
  const double bearing_rad = std::atan2(target_R_m.y(), target_R_m.x());
  if (target_R_m.norm() > context->stop_distance_m + kNearEnough_m ||
      std::abs(bearing_rad) > kFaced_rad) {
    return Next{Phase::kApproach, "the target is in view and its place is known"};
  }
  context->view = sighting;
  return ChooseScan(context);
}

}  // namespace geon::mission
