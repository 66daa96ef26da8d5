#include "evaluation/look_by_table.h"

#include <algorithm>
#include <limits>
#include <span>

namespace geon::evaluation {
namespace {

int NextLook(std::span<const int> looks, int way, const ViewRound& round,
             const active_vision::ViewTable& table) {
  const auto taken = [looks](int look) {
    return std::any_of(looks.begin(), looks.end(),
                       [look](int other) { return (look - other) % kRoundViews == 0; });
  };
  const sensor::GeonVerdict fused = FuseLooks(round, looks, table.fusion);
  double best_1 = -std::numeric_limits<double>::infinity();
  int best = looks.back();
  for (int turns = 1; turns <= active_vision::kViewTurns; ++turns) {
    const double gain_1 = active_vision::ViewGain(table.gain, fused.posterior, turns);
    for (const int look : {looks.back() + way * turns, looks.back() - way * turns}) {
      if (taken(look) || gain_1 <= best_1) continue;
      best_1 = gain_1;
      best = look;
    }
  }
  return best;
}

FusedAnswer FuseAnswer(const ViewRound& round, std::span<const int> looks,
                       const active_vision::FusionOptions& fusion) {
  const sensor::GeonVerdict fused = FuseLooks(round, looks, fusion);
  return {fused.confidence, fused.label == round.truth};
}

}  // namespace

int BestTurn(const active_vision::ViewGainTable& gain, const sensor::GeonVerdict& verdict) {
  int best = 1;
  for (int turns = 2; turns <= active_vision::kViewTurns; ++turns) {
    if (active_vision::ViewGain(gain, verdict.posterior, turns) >
        active_vision::ViewGain(gain, verdict.posterior, best)) {
      best = turns;
    }
  }
  return best;
}

std::array<int, 3> LooksByTable(const ViewRound& round, int first, int way,
                                const active_vision::ViewTable& table) {
  std::array<int, 3> looks = {first, first, first};
  for (size_t k = 1; k < looks.size(); ++k) {
    looks[k] = NextLook(std::span(looks).first(k), way, round, table);
  }
  return looks;
}

std::vector<TableAnswers> AnswersByTable(std::span<const ViewRound> rounds,
                                         const active_vision::ViewTable& table) {
  std::vector<TableAnswers> answers;
  for (size_t r = 0; r < rounds.size(); ++r) {
    for (int first = 0; first < kRoundViews; ++first) {
      if (rounds[r].views[static_cast<size_t>(first)].decided) continue;
      for (const int way : {1, -1}) {
        const std::array<int, 3> looks = LooksByTable(rounds[r], first, way, table);
        answers.push_back({r, FuseAnswer(rounds[r], std::span(looks).first(2), table.fusion),
                           FuseAnswer(rounds[r], looks, table.fusion)});
      }
    }
  }
  return answers;
}

}  // namespace geon::evaluation
