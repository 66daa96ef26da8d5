#include "mission/sweep.h"

#include <algorithm>
#include <cmath>

namespace geon::mission {
namespace {

using active_vision::HeadAngles;
using sensor::Laser;
using sensor::PlannedStripe;

constexpr double kRunUp_1 = 0.25;        // of the way between the planned stripes, before and after
constexpr double kNearStart_rad = 0.03;  // there the laser is switched on ...
constexpr double kAtStart_rad = 0.004;   // ... and there the head turns round
constexpr double kBeyond_1 = 0.02;  // of the target: a stripe so far past the last is beyond it
constexpr double kNear_1 = 0.06;    // of the target, beside a planned stripe
constexpr double kAskAgain_s = 0.2;
constexpr double kLastFrames_s = 0.3;  // from the end of the turn to its last profile

HeadAngles Along(const PlannedStripe& a, const PlannedStripe& b, double part_1) {
  return {a.pan_rad + part_1 * (b.pan_rad - a.pan_rad),
          a.tilt_rad + part_1 * (b.tilt_rad - a.tilt_rad)};
}

double Apart(const HeadAngles& a, const HeadAngles& b) {
  return std::max(std::abs(a.pan_rad - b.pan_rad), std::abs(a.tilt_rad - b.tilt_rad));
}

}  // namespace

Sweep::Sweep(const sensor::ScanPlan& plan, const HeadAngles& from)
    : plan_(plan), nearest_(plan.stripes.size()) {
  HeadAngles at = from;
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const std::optional<Turn> turn = PlanTurn(laser, at);
    if (!turn) continue;
    turns_.push_back(*turn);
    at = turn->to;
  }
}

std::optional<Sweep::Turn> Sweep::PlanTurn(Laser laser, const HeadAngles& at) const {
  std::vector<PlannedStripe> stripes;
  for (const PlannedStripe& stripe : plan_.stripes) {
    if (stripe.laser == laser) stripes.push_back(stripe);
  }
  if (stripes.size() < 2) return std::nullopt;
  std::sort(stripes.begin(), stripes.end(),
            [](const PlannedStripe& a, const PlannedStripe& b) { return a.fraction < b.fraction; });
  Turn turn;
  turn.laser = laser;
  turn.from = Along(stripes.front(), stripes.back(), -kRunUp_1);
  turn.to = Along(stripes.front(), stripes.back(), 1.0 + kRunUp_1);
  turn.last_1 = stripes.back().fraction;
  if (Apart(at, turn.to) < Apart(at, turn.from)) {
    std::swap(turn.from, turn.to);
    turn.last_1 = stripes.front().fraction;
    turn.way_1 = -1.0;
  }
  turn.quarters_rad = Apart(turn.from, turn.to) / (1.0 + 2.0 * kRunUp_1);
  return turn;
}

void Sweep::Step(Context* context) {
  const Turn& turn = turns_[turn_];
  const LookingOptions& looking = context->options.looking;
  const active_vision::HeadLimits limits = context->senses.head_limits();
  context->text = "sweeping the " + std::string(ToString(turn.laser)) + " laser over the target";
  if (!begun_s_) {
    begun_s_ = context->time_s;
    asked_s_ = -1e9;
    context->head.Point(limits.Clamp(turn.from));
  }
  const sensor::PtuState& ptu = context->senses.ptu();
  const double to_start_rad = Apart({ptu.pan_rad, ptu.tilt_rad}, limits.Clamp(turn.from));
  if (turning_ || to_start_rad < kNearStart_rad) AskForLight(context);
  if (!turning_ && to_start_rad < kAtStart_rad) {
    turning_ = true;
    context->head.Point(limits.Clamp(turn.to), turn.quarters_rad / looking.sweep_s);
  }
  if (turning_ && !arrived_s_ && context->head.Settled(context->time_s, ptu, 0.0)) {
    arrived_s_ = context->time_s;
  }
  const bool over = arrived_s_ && context->time_s - *arrived_s_ > kLastFrames_s;
  const bool late = context->time_s - *begun_s_ > context->options.patience.stripe_s;
  if (beyond_ || over || late) NextTurn();
}

void Sweep::AskForLight(Context* context) {
  if (context->time_s - asked_s_ < kAskAgain_s || context->senses.base().moving) return;
  asked_s_ = context->time_s;
  sensor::ScanCommand command;
  command.scan_id = plan_.scan_id;
  command.stripe_index = sensor::kSweptStripe;
  command.attempt = sensor::kSweptStripe;
  command.laser = turns_[turn_].laser;
  context->wishes.scan_command = command;
}

void Sweep::Take(const sensor::RangeProfile& profile) {
  const bool measured = profile.status == sensor::ProfileStatus::kOk && profile.on_target > 0 &&
                        profile.stripe_index >= 0 &&
                        static_cast<size_t>(profile.stripe_index) < plan_.stripes.size();
  if (done() || !measured) return;
  auto& nearest = nearest_[static_cast<size_t>(profile.stripe_index)];
  const double off_1 = Misplacement(plan_, profile);
  if (off_1 <= kNear_1 && (!nearest || off_1 < Misplacement(plan_, *nearest))) nearest = profile;
  const Turn& turn = turns_[turn_];
  beyond_ |=
      profile.laser == turn.laser && (profile.fraction - turn.last_1) * turn.way_1 > kBeyond_1;
}

}  // namespace geon::mission
