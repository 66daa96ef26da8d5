#include "evaluation/view_report.h"

#include <array>
#include <cmath>
#include <numeric>

namespace geon::evaluation {
namespace {

using active_vision::kViewTurns;

// What a second look does, by turn (less 1), the mean of both ways.
struct SecondLooks {
  std::array<double, kViewTurns> right_1{};
  std::array<double, kViewTurns> nats_1{};
};

SecondLooks LookTwice(const ViewRound& round, int first,
                      const active_vision::FusionOptions& fusion) {
  SecondLooks seconds;
  for (int turns = 1; turns <= kViewTurns; ++turns) {
    const auto k = static_cast<size_t>(turns - 1);
    for (const int way : {1, -1}) {
      const std::array<int, 2> looks = {first, first + way * turns};
      seconds.right_1[k] += FuseLooks(round, looks, fusion).label == round.truth ? 0.5 : 0.0;
    }
    seconds.nats_1[k] = NatsGained(round, first, turns, fusion);
  }
  return seconds;
}

double MeanOf(const std::array<double, kViewTurns>& values_1) {
  return std::accumulate(values_1.begin(), values_1.end(), 0.0) / kViewTurns;
}

void ExamineRound(const ViewRound& round, const active_vision::ViewTable& table,
                  ViewReport* report) {
  for (int first = 0; first < kRoundViews; ++first) {
    const sensor::GeonVerdict& look = round.views[static_cast<size_t>(first)];
    ++report->looks;
    if (look.decided) continue;
    ++report->undecided;
    const SecondLooks seconds = LookTwice(round, first, table.fusion);
    const auto best = static_cast<size_t>(BestTurn(table.gain, look) - 1);
    report->first.Count(look.label == round.truth ? 1.0 : 0.0);
    report->random.Count(MeanOf(seconds.right_1));
    report->table.Count(seconds.right_1[best]);
    for (size_t k = 0; k < kViewTurns; ++k) report->turned[k].Count(seconds.right_1[k]);
    report->right_more.Count(seconds.right_1[best] - MeanOf(seconds.right_1));
    report->nats_more.Count(seconds.nats_1[best] - MeanOf(seconds.nats_1));
  }
  for (ClusteredMean* mean :
       {&report->first, &report->table, &report->random, &report->right_more, &report->nats_more}) {
    mean->EndCluster();
  }
  for (ClusteredMean& mean : report->turned) mean.EndCluster();
}

// Counts what `value` says of each answer that it says something of.
template <typename Value>
ClusteredMean AverageAnswers(std::span<const TableAnswers> answers, const Value& value) {
  ClusteredMean mean;
  for (size_t k = 0; k < answers.size(); ++k) {
    value(answers[k], &mean);
    if (k + 1 == answers.size() || answers[k + 1].round != answers[k].round) mean.EndCluster();
  }
  return mean;
}

}  // namespace

double NatsGained(const ViewRound& round, int first, int turns,
                  const active_vision::FusionOptions& fusion) {
  const auto truth = static_cast<size_t>(round.truth);
  const double before_1 = FuseLooks(round, std::array{first}, fusion).posterior[truth];
  double gained_1 = -std::log(before_1);
  for (const int way : {1, -1}) {
    const std::array<int, 2> looks = {first, first + way * turns};
    gained_1 += 0.5 * std::log(FuseLooks(round, looks, fusion).posterior[truth]);
  }
  return gained_1;
}

ViewReport ExamineViews(std::span<const ViewRound> rounds, const active_vision::ViewTable& table) {
  ViewReport report;
  for (const ViewRound& round : rounds) ExamineRound(round, table, &report);
  const std::vector<TableAnswers> answers = AnswersByTable(rounds, table);
  const double decided_1 = table.fusion.decided_1;
  report.three = AverageAnswers(answers, [&](const TableAnswers& answer, ClusteredMean* mean) {
    mean->Count(answer.Last(decided_1).right ? 1.0 : 0.0);
  });
  report.decided = AverageAnswers(answers, [&](const TableAnswers& answer, ClusteredMean* mean) {
    mean->Count(answer.Last(decided_1).posterior_1 >= decided_1 ? 1.0 : 0.0);
  });
  report.decided_right = DecidedRight(answers, decided_1);
  return report;
}

ClusteredMean DecidedRight(std::span<const TableAnswers> answers, double decided_1) {
  return AverageAnswers(answers, [&](const TableAnswers& answer, ClusteredMean* mean) {
    const FusedAnswer& last = answer.Last(decided_1);
    if (last.posterior_1 >= decided_1) mean->Count(last.right ? 1.0 : 0.0);
  });
}

}  // namespace geon::evaluation
