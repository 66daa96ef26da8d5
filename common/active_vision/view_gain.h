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
// Source: learned from simulated pairs of views of random shapes (`geon train views`), by the two
// likeliest labels; what to do with it: Arbel and Ferrie, ICCV 1999.
double ViewGain(const std::array<double, kGeonLabelCount>& posterior_1, int turns);

}  // namespace geon::active_vision
