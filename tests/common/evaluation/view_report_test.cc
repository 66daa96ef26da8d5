#include "evaluation/view_report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::evaluation {
namespace {

sensor::GeonVerdict Cuboid(double posterior_1, bool decided) {
  sensor::GeonVerdict verdict;
  verdict.posterior.fill((1.0 - posterior_1) / 6.0);
  verdict.posterior[0] = posterior_1;
  verdict.confidence = posterior_1;
  verdict.decided = decided;
  if (posterior_1 < 0.1) {
    verdict.label = GeonLabel::kTaperedCuboid;
    verdict.posterior[3] += 0.5;
    verdict.confidence = verdict.posterior[3];
  }
  return verdict;
}

// A cuboid that is taken for a tapered one from one side, and told from 120 degrees farther, either
// way; from anywhere else it is not.
ViewRound ToldFromFourTurns() {
  ViewRound round;
  round.views.fill(Cuboid(0.05, true));
  round.views[0].decided = false;
  round.views[4] = round.views[8] = Cuboid(0.98, true);
  return round;
}

active_vision::ViewTable Table(size_t turns) {
  active_vision::ViewTable table;
  table.fusion = {1.0, 0.5};
  for (auto& by_second : table.gain) {
    for (auto& gain_1 : by_second) gain_1[turns - 1] = 1.0;
  }
  return table;
}

TEST(NatsGained, IsTheChangeOfTheLogPosteriorOfTheTruth) {
  ViewRound round;
  round.views.fill(Cuboid(0.4, false));
  const double after_1 = 0.4 * 0.4 / (0.4 * 0.4 + 6 * 0.1 * 0.1);
  EXPECT_NEAR(NatsGained(round, 0, 3, {1.0, 0.9}), std::log(after_1 / 0.4), 1e-12);
}

TEST(ExamineViews, CountsEachWayOfLookingTwice) {
  const ViewReport report = ExamineViews(std::array{ToldFromFourTurns()}, Table(4));
  EXPECT_EQ(report.looks, 12);
  EXPECT_EQ(report.undecided, 1);
  EXPECT_EQ(report.first.mean_1(), 0.0);
  EXPECT_EQ(report.turned[2].mean_1(), 0.0);
  EXPECT_EQ(report.turned[3].mean_1(), 1.0);
  EXPECT_EQ(report.table.mean_1(), 1.0);
  EXPECT_NEAR(report.random.mean_1(), 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(report.right_more.mean_1(), 5.0 / 6.0, 1e-12);
  EXPECT_GT(report.nats_more.mean_1(), 0.0);
  EXPECT_EQ(report.decided.mean_1(), 1.0);
  EXPECT_EQ(report.decided_right.mean_1(), 1.0);
}

TEST(ExamineViews, SeesThatATableIsWorseThanChance) {
  const ViewReport report = ExamineViews(std::array{ToldFromFourTurns()}, Table(3));
  EXPECT_LT(report.right_more.mean_1(), 0.0);
  EXPECT_LT(report.nats_more.mean_1(), 0.0);
}

TEST(DecidedRight, LeavesOutWhatIsNotDecided) {
  const std::vector<TableAnswers> answers = {{0, {0.95, true}, {0.2, false}},
                                             {0, {0.5, true}, {0.92, false}},
                                             {4, {0.5, true}, {0.6, true}}};
  EXPECT_EQ(DecidedRight(answers, 0.9).n(), 2);
  EXPECT_EQ(DecidedRight(answers, 0.9).mean_1(), 0.5);
  EXPECT_EQ(DecidedRight(answers, 0.9).clusters(), 1);
  EXPECT_EQ(DecidedRight(answers, 0.55).clusters(), 2);
  EXPECT_EQ(DecidedRight(answers, 0.99).n(), 0);
}

}  // namespace
}  // namespace geon::evaluation
