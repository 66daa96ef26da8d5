#pragma once

#include <array>
#include <span>

#include "active_vision/view_table.h"
#include "evaluation/clustered_mean.h"
#include "evaluation/look_by_table.h"
#include "evaluation/view_round.h"

namespace geon::evaluation {

// What looking again is good for. Looks cluster by the shape they show.
struct ViewReport {
  int looks = 0;      // first looks, each view of each round
  int undecided = 0;  // of these; all below is about them
  // Shares of right answers: by the first look; by two, the second turned as the table says, by 30
  // to 180 degrees at random, and by each of these (k + 1 turns); by the table and, where two do
  // not decide, a third.
  ClusteredMean first, table, random;
  std::array<ClusteredMean, active_vision::kViewTurns> turned;
  ClusteredMean three;
  ClusteredMean decided;        // share of answers that two or three looks decide ...
  ClusteredMean decided_right;  // ... of which so many are right
  // By the table more than at random: share of right answers, log posterior of the truth in nats.
  ClusteredMean right_more, nats_more;
};

// Either way round counts half.
ViewReport ExamineViews(std::span<const ViewRound> rounds, const active_vision::ViewTable& table);

// How much likelier the truth is by a look and another `turns` farther, in nats of its log
// posterior, the mean of both ways.
double NatsGained(const ViewRound& round, int first, int turns,
                  const active_vision::FusionOptions& fusion);

// Of the answers that two or three looks decide, how many are right.
ClusteredMean DecidedRight(std::span<const TableAnswers> answers, double decided_1);

}  // namespace geon::evaluation
