#include "mission/target_views.h"

#include <algorithm>
#include <cmath>

#include "active_vision/view_gain.h"
#include "base/angles.h"
#include "base/contracts.h"

namespace geon::mission {
namespace {

constexpr double kSameSide_rad = 0.35;
constexpr double kDrive_1 = 0.02;  // nats that driving 30 degrees farther round must be worth

bool IsAmong(const std::vector<double>& bearings_rad, double bearing_rad) {
  return std::any_of(bearings_rad.begin(), bearings_rad.end(), [&](double other_rad) {
    return std::abs(WrapAngle(bearing_rad - other_rad)) < kSameSide_rad;
  });
}

}  // namespace

void TargetViews::Clear() { *this = {}; }

void TargetViews::Add(const sensor::GeonVerdict& verdict, double bearing_rad,
                      const Eigen::Vector2d& middle_W_m) {
  verdicts_.push_back(verdict);
  bearings_rad_.push_back(bearing_rad);
  sum_W_m_ += middle_W_m;
}

Eigen::Vector2d TargetViews::middle_W_m() const {
  Require(!verdicts_.empty(), "TargetViews::middle_W_m: nothing was seen yet");
  return sum_W_m_ / static_cast<double>(verdicts_.size());
}

std::optional<double> TargetViews::NextBearing() const {
  const auto posterior_1 = Fused().posterior;
  std::optional<double> best_rad;
  double best_1 = 0.0;
  for (int turns = 1; turns <= active_vision::kViewTurns; ++turns) {
    const double worth_1 = active_vision::ViewGain(posterior_1, turns) - kDrive_1 * turns;
    for (const double way : {1.0, -1.0}) {
      const double bearing_rad =
          WrapAngle(bearings_rad_.back() + way * turns * active_vision::kViewTurn_rad);
      if (worth_1 <= best_1 || IsAmong(bearings_rad_, bearing_rad) ||
          IsAmong(closed_rad_, bearing_rad)) {
        continue;
      }
      best_1 = worth_1;
      best_rad = bearing_rad;
    }
  }
  return best_rad;
}

}  // namespace geon::mission
