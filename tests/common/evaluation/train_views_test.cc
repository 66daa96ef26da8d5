#include "evaluation/train_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "base/contracts.h"

namespace geon::evaluation {
namespace {

constexpr size_t kCuboid = 0, kTapered = 3, kEllipsoid = 2;

ViewTrainingOptions FewShapes() {
  ViewTrainingOptions options;
  options.shapes = 16;
  options.calibration_shapes = options.ordinary_shapes = options.held_out_shapes = 10;
  return options;
}

void InOrder(double /*share_1*/, int count, const std::function<void(int)>& task) {
  for (int k = 0; k < count; ++k) task(k);
}

// Each task in a thread of its own, the last one first.
void BackwardsInThreads(double /*share_1*/, int count, const std::function<void(int)>& task) {
  for (int k = count - 1; k >= 0; --k) std::thread(task, k).join();
}

sensor::GeonVerdict Says(size_t label, double posterior_1, size_t next, bool decided) {
  sensor::GeonVerdict verdict;
  verdict.posterior.fill((1.0 - posterior_1) / 12.0);
  verdict.posterior[next] = 0.5 * (1.0 - posterior_1) + (1.0 - posterior_1) / 12.0;
  verdict.posterior[label] = posterior_1;
  verdict.label = static_cast<GeonLabel>(label);
  verdict.confidence = posterior_1;
  verdict.decided = decided;
  return verdict;
}

// A cuboid, or a tapered one, that only the first view leaves open, and that 90 degrees tell best.
ViewRound OpenFromOneSide() {
  ViewRound round;
  round.views.fill(Says(kCuboid, 0.8, kTapered, true));
  round.views[0] = Says(kCuboid, 0.5, kTapered, false);
  round.views[3] = round.views[9] = Says(kCuboid, 0.99, kTapered, true);
  return round;
}

TEST(TrainViews, GivesTheSameBytesInAnyOrder) {
  ViewTrainingReport report, again;
  const auto table = TrainViews(FewShapes(), InOrder, &report);
  const auto same = TrainViews(FewShapes(), BackwardsInThreads, &again);
  EXPECT_EQ(ViewTableSource(table, FewShapes()), ViewTableSource(same, FewShapes()));
  EXPECT_EQ(report.training.looks, 10 * kRoundViews);
  EXPECT_EQ(report.ordinary.looks, 10 * kRoundViews);
  EXPECT_EQ(report.training.table.mean_1(), again.training.table.mean_1());
  EXPECT_GT(report.learned_from, 0);
}

TEST(TrainViews, HeldOutShapesDoNotChangeTheTable) {
  ViewTrainingOptions more = FewShapes();
  more.held_out_shapes = 12;
  ViewTrainingReport report;
  const auto table = TrainViews(FewShapes(), InOrder, &report);
  const auto same = TrainViews(more, InOrder, &report);
  EXPECT_EQ(table.gain, same.gain);
  EXPECT_EQ(table.fusion.weight_1, same.fusion.weight_1);
  EXPECT_EQ(table.fusion.decided_1, same.fusion.decided_1);
}

TEST(TrainViews, WantsEnoughShapes) {
  ViewTrainingOptions options = FewShapes();
  options.ordinary_shapes = 3;
  ViewTrainingReport report;
  EXPECT_THROW(TrainViews(options, InOrder, &report), ContractViolation);
}

TEST(MeanViewGains, ManyLooksMakeTheirOwnMean) {
  const std::vector<ViewRound> rounds(5000, OpenFromOneSide());
  const active_vision::FusionOptions fusion{1.0, 0.9};
  const auto table = MeanViewGains(rounds, fusion);
  for (int turns = 1; turns <= active_vision::kViewTurns; ++turns) {
    EXPECT_NEAR(table[kCuboid][kTapered][static_cast<size_t>(turns - 1)],
                NatsGained(rounds[0], 0, turns, fusion), 6e-4);
  }
  EXPECT_GT(table[kCuboid][kTapered][2], table[kCuboid][kTapered][1]);
}

// A label that came with another one, and a label that never came.
TEST(MeanViewGains, WhatWasNeverSeenFallsBackToTheLabelAndThenToAll) {
  std::vector<ViewRound> rounds(300, OpenFromOneSide());
  for (size_t k = 0; k < 100; ++k) {
    rounds[k].truth = GeonLabel::kEllipsoid;
    rounds[k].views.fill(Says(kEllipsoid, 0.9, kTapered, true));
    rounds[k].views[0] = Says(kEllipsoid, 0.6, kTapered, false);
  }
  const auto table = MeanViewGains(rounds, {1.0, 0.9});
  EXPECT_EQ(table[5][6], table[6][4]) << "labels that never came: the mean of all";
  EXPECT_EQ(table[kEllipsoid][0], table[kEllipsoid][1]) << "pairs that never came: the label's";
  EXPECT_NE(table[kEllipsoid][0], table[5][6]);
  // A pair of few looks lies between its own mean and that of all.
  const double own_1 = NatsGained(rounds[0], 0, 3, {1.0, 0.9}), all_1 = table[5][6][2];
  EXPECT_GT(std::abs(table[kEllipsoid][kTapered][2] - own_1), 1e-3);
  EXPECT_LT(std::abs(table[kEllipsoid][kTapered][2] - own_1), std::abs(all_1 - own_1));
}

TEST(MeanViewGains, WithoutLooksNothingIsGained) {
  EXPECT_EQ(MeanViewGains({}, {1.0, 0.9}), active_vision::ViewGainTable{});
}

// Views that say the same eleven times over know no more than one of them.
TEST(FitViewWeight, IsLowWhereViewsRepeatTheSameErrorAndHighWhereTheyAreRight) {
  std::vector<ViewRound> alike(2);
  for (ViewRound& round : alike) round.views.fill(Says(kCuboid, 0.6, kTapered, false));
  alike[1].truth = GeonLabel::kTaperedCuboid;  // 0.6 is about right
  std::vector<ViewRound> right(1, alike[0]);
  EXPECT_LT(FitViewWeight(alike), 0.7) << "two that say the same are one: half of each";
  EXPECT_GT(FitViewWeight(right), 1.0);
}

TEST(ViewTableSource, SaysHowItWasMadeAndHoldsEveryNumber) {
  active_vision::ViewTable table;
  table.fusion = {0.65, 0.915};
  table.gain[6][5][4] = 0.123;
  const std::string source = ViewTableSource(table, FewShapes());
  EXPECT_NE(source.find("`geon train views --seed 1 --shapes 16 --calibration-shapes 10 "
                        "--ordinary-shapes 10`"),
            std::string::npos);
  EXPECT_NE(source.find("{{0.650, 0.915}, {{"), std::string::npos);
  EXPECT_NE(source.find("0.123"), std::string::npos);
  size_t numbers = 0;
  for (const char c : source.substr(source.find('\n'))) numbers += c == '.' ? 1 : 0;
  EXPECT_EQ(numbers, 2U + 7U * 7U * 6U);
}

}  // namespace
}  // namespace geon::evaluation
