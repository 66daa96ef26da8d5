#include "mission/search_phase.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace geon::mission {

namespace {

constexpr double kFacingSector_rad = 0.06;
constexpr double kTurnPatience_s = 8.0;
constexpr int kFloorSightings = 2;  // one alone may be a speck
const active_vision::HeadAngles kAhead{0.0, -0.1};

}  // namespace

void SearchPhase::Enter(Context* context, bool near) {
  // One that was seen and lost is somewhere: what was looked at in vain is in doubt.
  if (context->target.known()) context->coverage.Clear();
  context->target.Clear();
  context->view.reset();
  context->stop_distance_m = context->options.looking.stop_distance_m;
  context->drive.Rest();
  floor_sightings_ = 0;
  sectors_ = 0;
  const bool by_map = context->options.driving.planner == PlannerKind::kMap;
  if (by_map && !near) {
    StartCovering();
    return;
  }
  StartSweep(context, near ? context->options.looking.near : context->options.looking.sweep);
}

void SearchPhase::StartCovering() {
  leg_ = Leg::kCover;
  coverage_.Enter();
}

void SearchPhase::Cover(Context* context) {
  const Senses& senses = context->senses;
  if (senses.map() == nullptr) return;
  if (senses.odometry_epoch() != odometry_epoch_) {
    odometry_epoch_ = senses.odometry_epoch();
    context->coverage.Clear();
  }
  const auto& looking = context->options.looking;
  if (const auto& head = senses.head(); head && !head->seen.target) {
    context->coverage.Look(
        context->rig.color_camera,
        head->X_WR * context->rig.ColorCameraPose(head->head.pan_rad, head->head.tilt_rad),
        looking.next_view.farthest_m, *senses.map());
  }
  if (const auto& floor = senses.floor(); floor && !floor->seen.target) {
    context->coverage.Look(context->rig.floor_camera, floor->X_WR * context->rig.X_RF,
                           looking.next_view.floor_far_m, *senses.map());
  }
}

Transition SearchPhase::Step(Context* context) {
  const auto& head = context->senses.head();
  if (head && head->seen.target) {
    context->wishes.decision = Decision{*head, 0};
    const Eigen::Vector3d gaze_W_m = GazeAtTarget(*context, *head);
    if (const auto aim = AimAt(*context, gaze_W_m.head<2>(), gaze_W_m.z())) {
      context->head.Point(*aim);
    }
    context->target.See(*head);
    const bool by_map = context->options.driving.planner == PlannerKind::kMap;
    return Next{by_map && context->target.known() ? Phase::kApproach : Phase::kCentre,
                "the head camera sees the target's colour"};
  }
  const auto& floor = context->senses.floor();
  if (floor) {
    context->target.See(*floor);
    floor_sightings_ = floor->seen.target ? floor_sightings_ + 1 : 0;
    if (floor_sightings_ >= kFloorSightings && context->target.known()) {
      return Next{Phase::kApproach, "the floor camera sees the target's colour"};
    }
  }
  Cover(context);
  switch (leg_) {
    case Leg::kCover:
      return coverage_.Step(context);
    case Leg::kSweep:
      Sweep(context);
      break;
    case Leg::kTurn:
      Turn(context);
      break;
    case Leg::kWander:
      Wander(context);
      break;
  }
  return std::nullopt;
}

void SearchPhase::StartSweep(Context* context, const active_vision::SearchOptions& area) {
  leg_ = Leg::kSweep;
  const auto& ptu = context->senses.ptu();
  looks_.clear();
  for (const auto& at :
       active_vision::SearchPattern(context->rig.color_camera, context->senses.head_limits(),
                                    {ptu.pan_rad, ptu.tilt_rad}, area)) {
    looks_.push_back({at});
  }
  tolerance_ = active_vision::LookTolerance(context->rig.color_camera, area);
  leg_since_s_ = look_since_s_ = context->time_s;
}

void SearchPhase::TakeLooks(const HeadSighting& sighting, double time_s) {
  for (Look& look : looks_) {
    if (look.taken || std::abs(sighting.head.pan_rad - look.at.pan_rad) > tolerance_.pan_rad ||
        std::abs(sighting.head.tilt_rad - look.at.tilt_rad) > tolerance_.tilt_rad) {
      continue;
    }
    look.taken = true;
    look_since_s_ = time_s;
  }
}

active_vision::HeadAngles SearchPhase::Aim(const Look& first, double tilt_rad) const {
  if (std::abs(tilt_rad - first.at.tilt_rad) > tolerance_.tilt_rad) return first.at;
  active_vision::HeadAngles aim = first.at;
  for (const Look& look : looks_) {
    if (!look.taken && look.at.tilt_rad == first.at.tilt_rad) aim = look.at;
  }
  return aim;
}

void SearchPhase::Sweep(Context* context) {
  if (context->senses.head()) TakeLooks(*context->senses.head(), context->time_s);
  const auto left =
      std::find_if(looks_.begin(), looks_.end(), [](auto& look) { return !look.taken; });
  if (left == looks_.end()) {
    NextLeg(context);
    return;
  }
  const auto taken =
      std::count_if(looks_.begin(), looks_.end(), [](auto& look) { return look.taken; });
  context->text = "sweeping the head, look " + std::to_string(taken + 1) + " of " +
                  std::to_string(looks_.size());
  context->head.Point(Aim(*left, context->senses.ptu().tilt_rad));
  if (context->time_s - look_since_s_ <= context->options.patience.image_s) return;
  left->taken = true;  // no picture came of it: out of reach, or the camera is away
  look_since_s_ = context->time_s;
}

void SearchPhase::Turn(Context* context) {
  context->text = "turning to the next sector";
  const double rest_rad = WrapAngle(heading_W_rad_ - context->senses.base().heading_rad);
  context->wishes.velocity = context->drive.TurnTo(rest_rad);
  if (std::abs(rest_rad) < kFacingSector_rad || context->time_s - leg_since_s_ > kTurnPatience_s) {
    StartSweep(context, context->options.looking.sweep);
  }
}

void SearchPhase::Wander(Context* context) {
  context->text = "wandering to see more";
  context->head.Point(kAhead);
  context->wishes.velocity = context->drive.Wander(context->time_s, context->senses);
  if (context->time_s - leg_since_s_ > context->options.driving.wander_s) {
    context->drive.Rest();
    sectors_ = 0;
    StartSweep(context, context->options.looking.sweep);
  }
}

void SearchPhase::NextLeg(Context* context) {
  leg_since_s_ = context->time_s;
  if (context->options.driving.planner == PlannerKind::kMap) {
    StartCovering();
    return;
  }
  const double sector_rad = context->options.looking.sector_rad;
  const int sectors = static_cast<int>(std::ceil(2.0 * kPi / sector_rad - 1e-9));
  if (++sectors_ < sectors) {
    leg_ = Leg::kTurn;
    heading_W_rad_ = WrapAngle(context->senses.base().heading_rad + sector_rad);
  } else {
    leg_ = Leg::kWander;
  }
}

}  // namespace geon::mission
