#pragma once

#include <array>
#include <span>
#include <vector>

#include "active_vision/view_table.h"
#include "evaluation/view_round.h"

namespace geon::evaluation {

// Of 1 ... kViewTurns, from where another look will tell most; of equals the nearest.
int BestTurn(const active_vision::ViewGainTable& gain, const sensor::GeonVerdict& verdict);

// A look that did not decide and the two that the table asks for after it: always the one that
// will tell most of those not taken yet, counted on from the last one, by what all looks so far say
// together. `way` (1 or -1) is taken round the target where both ways are as good.
std::array<int, 3> LooksByTable(const ViewRound& round, int first, int way,
                                const active_vision::ViewTable& table);

// What two looks and what three say together.
struct FusedAnswer {
  double posterior_1 = 0.0;
  bool right = false;
};
struct TableAnswers {
  size_t round = 0;
  FusedAnswer two, three;
  // A third look is taken only where two do not decide.
  const FusedAnswer& Last(double decided_1) const {
    return two.posterior_1 >= decided_1 ? two : three;
  }
};
// Of each look that did not decide, in the order of the rounds: two, one for each way round.
std::vector<TableAnswers> AnswersByTable(std::span<const ViewRound> rounds,
                                         const active_vision::ViewTable& table);

}  // namespace geon::evaluation
