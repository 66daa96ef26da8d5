#pragma once

#include <array>
#include <numbers>

#include "base/geon_label.h"

namespace geon::active_vision {

// Turns round the target that are weighed: 30 degrees apart, either way the same.
inline constexpr int kViewTurns = 6;
inline constexpr double kViewTurn_rad = std::numbers::pi / kViewTurns;

// How much likelier the right answer becomes, in nats of its log posterior, by another look at a
// target from `turns` times kViewTurn_rad (1 ... kViewTurns) farther round it, after a look that
// gave this posterior and did not decide.
//
// Source: ours, a rule of thumb: what a look leaves open (the posterior's entropy, Arbel and
// Ferrie, "Viewpoint selection by navigation through entropy maps", ICCV 1999) is told best by one
// that shows most of what the first did not and is no mirror of it. Geons with edges look alike
// after a right angle, and all of them from the far side; 60 degrees is neither.
double ViewGain(const std::array<double, kGeonLabelCount>& posterior_1, int turns);

}  // namespace geon::active_vision
