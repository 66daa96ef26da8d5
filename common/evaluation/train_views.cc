#include "evaluation/train_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "base/contracts.h"
#include "base/plain_name.h"
#include "evaluation/look_by_table.h"

namespace geon::evaluation {
namespace {

using active_vision::FusionOptions;
using active_vision::kViewTurns;
using active_vision::ViewGainTable;
using active_vision::ViewTable;

constexpr int kFewestShapes = 10;
constexpr double kFusedRight_1 = 0.99;   // of the decided answers to ordinary shapes are right
constexpr double kLooksOfPrior_1 = 100;  // that what more looks tell counts as
constexpr double kGainStep_1 = 0.001;    // to which the table is rounded

std::vector<ViewRound> LookRounds(ShapeKind kind, int first, int count,
                                  const ViewTrainingOptions& options, const ForEach& for_each) {
  const int all = options.shapes + options.calibration_shapes + options.ordinary_shapes +
                  2 * options.held_out_shapes;
  std::vector<ViewRound> rounds(static_cast<size_t>(count));
  for_each(static_cast<double>(count) / all, count, [&](int k) {
    rounds[static_cast<size_t>(k)] =
        LookRound(options.seed, static_cast<uint64_t>(first) + static_cast<uint64_t>(k), kind);
  });
  return rounds;
}

int CountUndecided(std::span<const ViewRound> rounds) {
  int undecided = 0;
  for (const ViewRound& round : rounds) {
    undecided += static_cast<int>(
        std::count_if(round.views.begin(), round.views.end(),
                      [](const sensor::GeonVerdict& view) { return !view.decided; }));
  }
  return undecided;
}

// Of one look, over all second looks.
double LogLikelihoodOfPairs(const ViewRound& round, int first, const FusionOptions& fusion) {
  const auto truth = static_cast<size_t>(round.truth);
  double sum = 0.0;
  for (int turns = 1; turns < kRoundViews; ++turns) {
    sum += std::log(FuseLooks(round, std::array{first, first + turns}, fusion).posterior[truth]);
  }
  return sum;
}

// Gains of several looks, by turn (less 1).
struct Gains {
  double looks = 0.0;
  std::array<double, kViewTurns> sum_1{};

  void Count(const std::array<double, kViewTurns>& gain_1) {
    looks += 1.0;
    for (size_t k = 0; k < sum_1.size(); ++k) sum_1[k] += gain_1[k];
  }
  // Their mean, as if `prior_looks` of the mean `prior_1` were among them.
  std::array<double, kViewTurns> Mean(double prior_looks,
                                      const std::array<double, kViewTurns>& prior_1) const {
    std::array<double, kViewTurns> mean_1{};
    const double all = std::max(looks + prior_looks, 1.0);
    for (size_t k = 0; k < mean_1.size(); ++k) {
      mean_1[k] = (sum_1[k] + prior_looks * prior_1[k]) / all;
    }
    return mean_1;
  }
};

double RoundedGain(double gain_1) { return kGainStep_1 * std::round(gain_1 / kGainStep_1); }

// The least limit that is high enough; else that of the highest lower end.
double DecidedFromAnswers(std::span<const TableAnswers> answers, double* low_1) {
  double best_1 = 1.0;
  *low_1 = 0.0;
  for (int step = 100; step < 200; ++step) {
    const double decided_1 = 0.005 * step;
    const double here_1 = DecidedRight(answers, decided_1).ShareInterval().low_1;
    if (here_1 <= *low_1) continue;
    *low_1 = here_1;
    best_1 = decided_1;
    if (here_1 > kFusedRight_1) break;
  }
  return best_1;
}

}  // namespace

double FitViewWeight(std::span<const ViewRound> rounds) {
  double best = -std::numeric_limits<double>::infinity(), best_1 = 1.0;
  for (int step = 4; step <= 24; ++step) {
    const FusionOptions fusion{0.05 * step, 1.0};
    double likelihood = 0.0;
    for (const ViewRound& round : rounds) {
      for (int first = 0; first < kRoundViews; ++first) {
        if (round.views[static_cast<size_t>(first)].decided) continue;
        likelihood += LogLikelihoodOfPairs(round, first, fusion);
      }
    }
    if (likelihood <= best) continue;
    best = likelihood;
    best_1 = fusion.weight_1;
  }
  return best_1;
}

ViewGainTable MeanViewGains(std::span<const ViewRound> rounds, const FusionOptions& fusion) {
  Gains all;
  std::array<Gains, kGeonLabelCount> by_first;
  std::array<std::array<Gains, kGeonLabelCount>, kGeonLabelCount> by_pair;
  for (const ViewRound& round : rounds) {
    for (int first = 0; first < kRoundViews; ++first) {
      const sensor::GeonVerdict& look = round.views[static_cast<size_t>(first)];
      if (look.decided) continue;
      std::array<double, kViewTurns> gain_1{};
      for (int turns = 1; turns <= kViewTurns; ++turns) {
        gain_1[static_cast<size_t>(turns - 1)] = NatsGained(round, first, turns, fusion);
      }
      const auto [likeliest, next] = active_vision::LikeliestTwo(look.posterior);
      all.Count(gain_1);
      by_first[likeliest].Count(gain_1);
      by_pair[likeliest][next].Count(gain_1);
    }
  }
  ViewGainTable table{};
  for (size_t i = 0; i < table.size(); ++i) {
    const auto mean_1 = by_first[i].Mean(kLooksOfPrior_1, all.Mean(0.0, {}));
    for (size_t j = 0; j < table.size(); ++j) {
      table[i][j] = by_pair[i][j].Mean(kLooksOfPrior_1, mean_1);
      std::transform(table[i][j].begin(), table[i][j].end(), table[i][j].begin(), RoundedGain);
    }
  }
  return table;
}

ViewTable TrainViews(const ViewTrainingOptions& options, const ForEach& for_each,
                     ViewTrainingReport* report) {
  const int fewest = std::min({options.shapes, options.calibration_shapes, options.ordinary_shapes,
                               options.held_out_shapes});
  Require(fewest >= kFewestShapes, "the fewest shapes of a step are", fewest,
          "but training wants 10 for each");
  const int calibration_from = options.shapes;
  const int held_out_from = options.shapes + options.calibration_shapes;
  ViewTable table;
  {
    const auto rounds = LookRounds(ShapeKind::kTraining, calibration_from,
                                   options.calibration_shapes, options, for_each);
    report->weighted_by = CountUndecided(rounds);
    table.fusion.weight_1 = FitViewWeight(rounds);
  }
  {
    const auto rounds = LookRounds(ShapeKind::kTraining, 0, options.shapes, options, for_each);
    report->learned_from = CountUndecided(rounds);
    table.gain = MeanViewGains(rounds, table.fusion);
  }
  {
    const auto rounds =
        LookRounds(ShapeKind::kOrdinary, 0, options.ordinary_shapes, options, for_each);
    report->decided_by = CountUndecided(rounds);
    table.fusion.decided_1 =
        DecidedFromAnswers(AnswersByTable(rounds, table), &report->decided_right_1);
  }
  report->training = ExamineViews(
      LookRounds(ShapeKind::kTraining, held_out_from, options.held_out_shapes, options, for_each),
      table);
  report->ordinary = ExamineViews(LookRounds(ShapeKind::kOrdinary, options.ordinary_shapes,
                                             options.held_out_shapes, options, for_each),
                                  table);
  return table;
}

std::string ViewTableSource(const ViewTable& table, const ViewTrainingOptions& options) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "// Made by `geon train views --seed "
       << options.seed << " --shapes " << options.shapes << " --calibration-shapes "
       << options.calibration_shapes << " --ordinary-shapes " << options.ordinary_shapes
       << "`; do not edit.\n"
       << "constexpr ViewTable kViewTable = {{" << table.fusion.weight_1 << ", "
       << table.fusion.decided_1 << "}, {{\n";
  for (size_t i = 0; i < table.gain.size(); ++i) {
    text << "    {{  // likeliest: " << PlainName(static_cast<GeonLabel>(i)) << '\n';
    for (const std::array<double, kViewTurns>& gains_1 : table.gain[i]) {
      text << "        {{";
      for (size_t k = 0; k < gains_1.size(); ++k) text << (k > 0 ? ", " : "") << gains_1[k];
      text << "}},\n";
    }
    text << "    }},\n";
  }
  text << "}}};\n";
  return text.str();
}

}  // namespace geon::evaluation
