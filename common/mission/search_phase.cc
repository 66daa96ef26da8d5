#include "mission/search_phase.h"

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
  context->target.Clear();
  context->view.reset();
  context->stop_distance_m = context->options.looking.stop_distance_m;
  context->drive.Rest();
  floor_sightings_ = 0;
  sectors_ = 0;
  StartSweep(context, near ? context->options.looking.near : context->options.looking.sweep);
}

Transition SearchPhase::Step(Context* context) {
  const auto& head = context->senses.head();
  if (head && head->seen.target) {
    context->wishes.decision = Decision{*head, 0};
    context->head.Point(context->senses.head_limits().Clamp(head->head));
    return Next{Phase::kCentre, "the head camera sees the target's colour"};
  }
  const auto& floor = context->senses.floor();
  if (floor) {
    context->target.See(*floor);
    floor_sightings_ = floor->seen.target ? floor_sightings_ + 1 : 0;
    if (floor_sightings_ >= kFloorSightings && context->target.known()) {
      return Next{Phase::kApproach, "the floor camera sees the target's colour"};
    }
  }
  switch (leg_) {
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
  looks_ = active_vision::SearchPattern(context->rig.color_camera, context->senses.head_limits(),
                                        {ptu.pan_rad, ptu.tilt_rad}, area);
  look_ = 0;
  leg_since_s_ = look_since_s_ = context->time_s;
}

void SearchPhase::Sweep(Context* context) {
  context->text = "sweeping the head, look " + std::to_string(look_ + 1) + " of " +
                  std::to_string(looks_.size());
  if (look_ >= looks_.size()) {
    NextLeg(context);
    return;
  }
  context->head.Point(looks_[look_]);
  const auto& head = context->senses.head();
  const bool looked = head && head->still && Same(head->head, looks_[look_]);
  const bool late = context->time_s - look_since_s_ > context->options.patience.image_s;
  if (!looked && !late) return;
  ++look_;
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
