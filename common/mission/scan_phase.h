#pragma once

#include <vector>

#include "active_vision/place_stripes.h"
#include "mission/phase.h"
#include "mission/sweep.h"
#include "sensor/target_mask.h"

namespace geon::mission {

// Lays the six stripes (thesis 4.2.4). While sweeping (sweep.h), what the sweep measured counts,
// and only what it missed is laid as follows. Else all are laid one after another, in the order
// that turns the head least: head to its angles, still, stripe asked for until its profile answers.
// Once a stripe has told how far the surface is, the others are placed by that. A stripe that is
// missing is asked for again, a little beside, before the head moves on. Then the head goes back
// and the verdict is awaited. The robot stands still throughout.
//
// The first profile tells whether the supposed height of the support is right: if the distances do
// not agree, the other height is taken and the scan starts anew, as it does when the recognizer
// lost its memory.
class ScanPhase {
 public:
  void Enter(Context* context);
  Transition Step(Context* context);

 private:
  Transition Begin(Context* context);
  void BeginStops(Context* context);
  void EndStops(Context* context);
  Transition StepSweep(Context* context);
  Transition LayStripe(Context* context);
  void PointAtStripe(Context* context);
  active_vision::HeadAngles StripeHead(const Context& context) const;
  const sensor::PlannedStripe& stripe() const { return plan_.stripes[order_[turn_]]; }
  int32_t StripeIndex() const;  // one past the last when all are laid
  bool all_laid() const { return turn_ >= order_.size(); }
  Transition NextAttempt(Context* context);
  void NextStripe(Context* context);
  Transition Answered(Context* context, const sensor::RangeProfile& profile);
  bool HeightAgrees(Context* context, const sensor::RangeProfile& profile);
  Transition AwaitVerdict(Context* context);
  Transition ScanAgain(Context* context, const std::string& why);
  void SendPlan(Context* context);
  std::optional<Eigen::Vector2d> PlaceOfTarget(const Context& context) const;

  bool begun_ = false;
  sensor::ScanPlan plan_;
  sensor::TargetMask mask_;
  double tilt_step_rad_ = 0.0;  // a re-placed stripe's shift
  double pan_step_rad_ = 0.0;
  active_vision::StripeTarget target_;
  std::optional<Sweep> sweep_;
  std::vector<size_t> order_;  // in which the plan's stripes are laid
  size_t turn_ = 0;            // of `order_`
  int attempt_ = 0;
  std::vector<sensor::RangeProfile> measured_;
  bool answered_ = false;  // by a profile, with or without a stripe
  bool height_verified_ = false;
  bool height_changed_ = false;
  int32_t newest_profile_seq_ = 0;
  double plan_sent_s_ = -1e9;
  double command_sent_s_ = -1e9;
  double stripe_since_s_ = 0.0;
  double all_laid_s_ = 0.0;
};

}  // namespace geon::mission
