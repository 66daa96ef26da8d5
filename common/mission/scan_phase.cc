#include "mission/scan_phase.h"

#include <cmath>

#include "active_vision/order_stripes.h"
#include "active_vision/surface_distance.h"
#include "active_vision/target_middle.h"
#include "attention/target_mask.h"
#include "mission/scan_geometry.h"

namespace geon::mission {

namespace {

constexpr double kResendPlan_s = 1.0;
constexpr double kResendCommand_s = 0.3;
constexpr double kResendEnd_s = 0.5;
constexpr double kShift_1 = 0.06;              // of the target's size, when a stripe is re-placed
constexpr double kHalfTarget_m = 0.08;         // from its foot to its middle, roughly
constexpr double kDistanceTolerance_m = 0.30;  // of the measured against the supposed distance

// One stripe beside, the next beside on the other side.
double ShiftOfAttempt(int attempt) {
  if (attempt == 0) return 0.0;
  return attempt % 2 == 1 ? kShift_1 : -kShift_1;
}

}  // namespace

void ScanPhase::Enter(Context* context) {
  begun_ = false;
  height_changed_ = false;
  context->drive.Rest();
}

Transition ScanPhase::Step(Context* context) {
  if (!begun_) {
    if (auto next = Begin(context)) return next;
  }
  context->scan_id = plan_.scan_id;
  context->stripe_index = StripeIndex();
  SendPlan(context);
  for (const auto& verdict : context->verdicts) {
    if (verdict.scan_id != plan_.scan_id) continue;
    context->scanned_W_m = PlaceOfTarget(*context);
    return Next{Phase::kDone, "", verdict};
  }
  for (const auto& profile : context->profiles) {
    if (profile.seq < newest_profile_seq_) {
      newest_profile_seq_ = profile.seq;
      return ScanAgain(context, "the recognizer started anew");
    }
    newest_profile_seq_ = profile.seq;
    answered_ = answered_ || profile.scan_id == plan_.scan_id;
    if (sweep_) {
      if (profile.scan_id != plan_.scan_id) continue;
      if (!HeightAgrees(context, profile)) return Begin(context);
      sweep_->Take(profile);
      continue;
    }
    const bool ours = profile.scan_id == plan_.scan_id && !all_laid() &&
                      profile.stripe_index == StripeIndex() && profile.attempt == attempt_;
    if (!ours) continue;
    if (auto next = Answered(context, profile)) return next;
  }
  if (sweep_) return StepSweep(context);
  return all_laid() ? AwaitVerdict(context) : LayStripe(context);
}

std::optional<Eigen::Vector2d> ScanPhase::PlaceOfTarget(const Context& context) const {
  const auto middle_L_m = active_vision::TargetMiddle(
      measured_, Eigen::Vector2d(plan_.distance_m + kHalfTarget_m, 0.0));
  if (!middle_L_m) return std::nullopt;
  const geometry::RigidTransform X_WL =
      context.view->X_WR *
      geometry::LevelFrame(context.rig.StripeCameraPose(plan_.pan_rad, plan_.tilt_rad),
                           plan_.support_height_m);
  return geometry::OnGround(X_WL, *middle_L_m);
}

Transition ScanPhase::StepSweep(Context* context) {
  if (!sweep_->done()) sweep_->Step(context);
  if (!sweep_->done()) return std::nullopt;
  for (const auto& profile : sweep_->nearest()) {
    if (profile) measured_.push_back(*profile);
  }
  std::erase_if(order_, [&](size_t k) { return sweep_->nearest()[k].has_value(); });
  sweep_.reset();
  BeginStops(context);
  return all_laid() ? AwaitVerdict(context) : std::nullopt;
}

int32_t ScanPhase::StripeIndex() const {
  return static_cast<int32_t>(all_laid() ? plan_.stripes.size() : order_[turn_]);
}

Transition ScanPhase::Begin(Context* context) {
  const SupportHypothesis* support = context->target.Best();
  const HeadSighting& view = *context->view;
  const auto standing =
      support == nullptr ? std::nullopt : Standing(context->rig, view, support->support_height_m);
  if (!standing) return Next{Phase::kSearch, "the target's place is not known"};
  target_ = {view.seen.target->box, view.head, standing->foot.distance_from_camera_m};
  auto placement = active_vision::PlaceStripes(context->rig, target_, context->senses.head_limits(),
                                               context->options.looking.placement);
  if (!placement.complete()) {
    const auto reached = static_cast<int>(placement.stripes.size());
    if (reached < context->options.patience.min_stripes ||
        context->counters.back_offs < context->options.patience.back_offs) {
      return StepBack(context, "the head cannot lay every stripe from here");
    }
  }
  plan_ = {};
  plan_.scan_id = context->next_scan_id++;
  plan_.target_box = target_.box;
  plan_.pan_rad = view.head.pan_rad;
  plan_.tilt_rad = view.head.tilt_rad;
  plan_.support_height_m = support->support_height_m;
  plan_.distance_m = target_.distance_m;
  plan_.stripes = std::move(placement.stripes);
  mask_ = attention::MakeTargetMask(view.seen);
  mask_.scan_id = plan_.scan_id;
  mask_.pan_rad = plan_.pan_rad;
  mask_.tilt_rad = plan_.tilt_rad;
  tilt_step_rad_ = target_.box.h_px / context->rig.color_camera.fy_px;
  pan_step_rad_ = target_.box.w_px / context->rig.color_camera.fx_px;
  context->wishes.decision = Decision{view, plan_.scan_id};

  begun_ = true;
  order_ = active_vision::OrderStripes(plan_.stripes, view.head);
  turn_ = 0;
  attempt_ = 0;
  measured_.clear();
  answered_ = false;
  height_verified_ = false;
  plan_sent_s_ = -1e9;
  sweep_.reset();
  if (context->options.looking.scan == ScanMode::kSweep) {
    sweep_.emplace(plan_, view.head);
  } else {
    BeginStops(context);
  }
  return std::nullopt;
}

// To the first stripe of `order_`, or straight to the end where nothing is left to lay.
void ScanPhase::BeginStops(Context* context) {
  if (all_laid()) {
    EndStops(context);
  } else {
    PointAtStripe(context);
  }
}

void ScanPhase::EndStops(Context* context) {
  all_laid_s_ = context->time_s;
  command_sent_s_ = -1e9;
  context->head.Point({plan_.pan_rad, plan_.tilt_rad});
}

void ScanPhase::SendPlan(Context* context) {
  if (context->time_s - plan_sent_s_ < kResendPlan_s) return;
  plan_sent_s_ = context->time_s;
  context->wishes.scan_plan = plan_;
  context->wishes.target_mask = mask_;
}

// As planned, or by the surface as the stripes so far have measured it.
active_vision::HeadAngles ScanPhase::StripeHead(const Context& context) const {
  const sensor::PlannedStripe& planned = stripe();
  const auto distance_m = active_vision::SurfaceDistance(
      context.rig, target_, plan_.support_height_m, measured_, planned.laser, planned.fraction);
  if (distance_m) {
    active_vision::StripeTarget surface = target_;
    surface.distance_m = *distance_m;
    const auto head = active_vision::PlaceStripe(context.rig, surface, context.senses.head_limits(),
                                                 planned.laser, planned.fraction);
    if (head) return *head;
  }
  return {planned.pan_rad, planned.tilt_rad};
}

void ScanPhase::PointAtStripe(Context* context) {
  active_vision::HeadAngles head = StripeHead(*context);
  const double shift_1 = ShiftOfAttempt(attempt_);
  if (stripe().laser == sensor::Laser::kHorizontal) {
    head.tilt_rad += shift_1 * tilt_step_rad_;
  } else {
    head.pan_rad += shift_1 * pan_step_rad_;
  }
  context->head.Point(context->senses.head_limits().Clamp(head));
  stripe_since_s_ = context->time_s;
  command_sent_s_ = -1e9;
}

Transition ScanPhase::LayStripe(Context* context) {
  const auto total = std::to_string(order_.size());
  context->text = "laying stripe " + std::to_string(turn_ + 1) + " of " + total +
                  (attempt_ > 0 ? ", attempt " + std::to_string(attempt_ + 1) : "");
  if (context->time_s - stripe_since_s_ > context->options.patience.stripe_s) {
    return NextAttempt(context);
  }
  if (!context->head.Settled(context->time_s, context->senses.ptu(),
                             context->options.looking.settle_s) ||
      context->senses.base().moving) {
    return std::nullopt;
  }
  if (context->time_s - command_sent_s_ < kResendCommand_s) return std::nullopt;
  command_sent_s_ = context->time_s;
  sensor::ScanCommand command;
  command.scan_id = plan_.scan_id;
  command.stripe_index = StripeIndex();
  command.attempt = attempt_;
  command.laser = stripe().laser;
  context->wishes.scan_command = command;
  return std::nullopt;
}

Transition ScanPhase::Answered(Context* context, const sensor::RangeProfile& profile) {
  if (!HeightAgrees(context, profile)) return Begin(context);
  if (profile.status != sensor::ProfileStatus::kOk || profile.on_target == 0) {
    return NextAttempt(context);
  }
  measured_.push_back(profile);
  NextStripe(context);
  return std::nullopt;
}

// Once per scan, by the first horizontal stripe that tells a distance. A height that does not agree
// with it is given up for the one that does.
bool ScanPhase::HeightAgrees(Context* context, const sensor::RangeProfile& profile) {
  if (height_verified_ || profile.laser != sensor::Laser::kHorizontal) return true;
  const auto measured_m =
      MeasuredDistance(profile, context->rig.stripe_camera, plan_.target_box.w_px);
  if (!measured_m) return true;
  const auto height_m = HeightByDistance(*context, *measured_m, kDistanceTolerance_m);
  if (!height_m) return true;
  height_verified_ = *height_m == plan_.support_height_m;
  if (!height_verified_) context->target.Refute(plan_.support_height_m);
  return height_verified_;
}

Transition ScanPhase::NextAttempt(Context* context) {
  if (++attempt_ < context->options.patience.stripe_attempts) {
    PointAtStripe(context);
    return std::nullopt;
  }
  // Nothing at all where the target should be: it may stand elsewhere.
  if (measured_.empty() && !height_verified_ && !height_changed_ &&
      RefuteForAnother(context, plan_.support_height_m)) {
    height_changed_ = true;
    return Begin(context);
  }
  NextStripe(context);
  return std::nullopt;
}

void ScanPhase::NextStripe(Context* context) {
  attempt_ = 0;
  ++turn_;
  if (!all_laid()) {
    PointAtStripe(context);
    return;
  }
  EndStops(context);
}

Transition ScanPhase::AwaitVerdict(Context* context) {
  context->text = "waiting for the verdict";
  const auto& patience = context->options.patience;
  if (static_cast<int>(measured_.size()) < patience.min_stripes) {
    // Nothing at all where the target should be: it stands on another support, farther off.
    if (measured_.empty() && answered_) context->target.Refute(plan_.support_height_m);
    return ScanAgain(context,
                     "only " + std::to_string(measured_.size()) + " stripes were measured");
  }
  if (context->time_s - all_laid_s_ > patience.verdict_s) {
    return ScanAgain(context, "the recognizer gave no verdict");
  }
  // "No laser" ends the scan: the recognizer decides on what it has.
  if (context->time_s - command_sent_s_ < kResendEnd_s) return std::nullopt;
  command_sent_s_ = context->time_s;
  sensor::ScanCommand end;
  end.scan_id = plan_.scan_id;
  end.stripe_index = StripeIndex();
  context->wishes.scan_command = end;
  return std::nullopt;
}

Transition ScanPhase::ScanAgain(Context* context, const std::string& why) {
  if (++context->counters.scans >= context->options.patience.scans) {
    return Next{Phase::kDone, why + ", in " + std::to_string(context->counters.scans) + " scans"};
  }
  context->head.Point(context->view->head);
  return Next{Phase::kCentre, why + ": looking and scanning again"};
}

}  // namespace geon::mission
