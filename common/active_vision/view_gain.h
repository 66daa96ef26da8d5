#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "base/geon_label.h"

namespace geon::active_vision {

// Turns round the target that are weighed: 30 degrees apart, either way the same.
inline constexpr int kViewTurns = 6;
inline constexpr double kViewTurn_rad = std::numbers::pi / kViewTurns;

// Gains by the likeliest label, the second likeliest and the turn (less 1).
using ViewGainTable =
    std::array<std::array<std::array<double, kViewTurns>, kGeonLabelCount>, kGeonLabelCount>;

// How much likelier the right answer becomes, in nats of its log posterior, by another look at a
// target from `turns` times kViewTurn_rad (1 ... kViewTurns) farther round it, after a look that
// gave this posterior and did not decide. Other turns throw ContractViolation.
//
// Source: learned from simulated rounds of views of random shapes (`geon train views`), by the two
// likeliest labels; what to do with it: Arbel and Ferrie, ICCV 1999.
double ViewGain(const std::array<double, kGeonLabelCount>& posterior_1, int turns);

// The likeliest label and the second likeliest, as indices; of equals those that come first.
std::array<size_t, 2> LikeliestTwo(const std::array<double, kGeonLabelCount>& posterior_1);

// The same gain by a table that is not compiled in.
double ViewGain(const ViewGainTable& table, const std::array<double, kGeonLabelCount>& posterior_1,
                int turns);

}  // namespace geon::active_vision
