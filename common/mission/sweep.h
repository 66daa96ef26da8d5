#pragma once

#include <optional>
#include <vector>

#include "mission/phase.h"

namespace geon::mission {

// Lays a plan's stripes while the head turns: once over the target with the horizontal laser
// burning, once across it with the vertical one. Every frame on the way is a stripe; of each
// planned one the nearest that was measured counts. A turn begins before the first planned stripe
// and ends when a stripe beyond the last was measured, or at its end.
//
// Source: ours; thesis 4.2.4 stops for each stripe.
class Sweep {
 public:
  // `from`: where the head is. A laser of which fewer than two stripes are planned is not swept.
  Sweep(const sensor::ScanPlan& plan, const active_vision::HeadAngles& from);

  bool done() const { return turn_ >= turns_.size(); }
  void Step(Context* context);
  // A profile of this scan, of whatever laser.
  void Take(const sensor::RangeProfile& profile);
  // For each planned stripe the nearest that was measured, at most 6 % of the target beside it.
  const std::vector<std::optional<sensor::RangeProfile>>& nearest() const { return nearest_; }

 private:
  struct Turn {
    sensor::Laser laser = sensor::Laser::kNone;
    active_vision::HeadAngles from, to;
    double last_1 = 0.0;        // fraction of the last planned stripe on the way
    double way_1 = 1.0;         // fractions grow on the way, or shrink (-1)
    double quarters_rad = 0.0;  // from the first planned stripe to the last
  };
  std::optional<Turn> PlanTurn(sensor::Laser laser, const active_vision::HeadAngles& at) const;
  void NextTurn() {
    ++turn_;
    begun_s_.reset();
    turning_ = false;
    beyond_ = false;
    arrived_s_.reset();
  }
  void AskForLight(Context* context);

  sensor::ScanPlan plan_;
  std::vector<Turn> turns_;
  size_t turn_ = 0;
  std::optional<double> begun_s_;  // this turn
  bool turning_ = false;           // at its start already
  bool beyond_ = false;            // the last planned stripe
  std::optional<double> arrived_s_;
  double asked_s_ = -1e9;
  std::vector<std::optional<sensor::RangeProfile>> nearest_;
};

}  // namespace geon::mission
