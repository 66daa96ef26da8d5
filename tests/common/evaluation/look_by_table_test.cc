#include "evaluation/look_by_table.h"

#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

constexpr size_t kCuboid = 0, kTapered = 3;

// A table by which after a cuboid `turns` tells most, and after a tapered cuboid 180 degrees.
active_vision::ViewTable Table(int turns) {
  active_vision::ViewTable table;
  table.fusion = {1.0, 0.9};
  for (auto& gain_1 : table.gain[kCuboid]) gain_1[static_cast<size_t>(turns - 1)] = 1.0;
  for (auto& gain_1 : table.gain[kTapered]) gain_1[5] = 1.0;
  return table;
}

sensor::GeonVerdict Look(double cuboid_1, double tapered_1, bool decided) {
  sensor::GeonVerdict verdict;
  verdict.posterior.fill(0.01);
  verdict.posterior[kCuboid] = cuboid_1;
  verdict.posterior[kTapered] = tapered_1;
  verdict.label = cuboid_1 > tapered_1 ? GeonLabel::kCuboid : GeonLabel::kTaperedCuboid;
  verdict.confidence = std::max(cuboid_1, tapered_1);
  verdict.decided = decided;
  return verdict;
}

ViewRound AlwaysCuboid() {
  ViewRound round;
  round.views.fill(Look(0.5, 0.4, true));
  return round;
}

TEST(BestTurn, IsTheOneOfTheGreatestGainAndTheNearestOfEquals) {
  EXPECT_EQ(BestTurn(Table(4).gain, Look(0.6, 0.3, false)), 4);
  EXPECT_EQ(BestTurn(Table(4).gain, Look(0.3, 0.6, false)), 6);
  EXPECT_EQ(BestTurn({}, Look(0.6, 0.3, false)), 1);
}

TEST(LooksByTable, GoOnFromTheLastLookTheWayTheyBegan) {
  EXPECT_EQ(LooksByTable(AlwaysCuboid(), 2, 1, Table(4)), (std::array{2, 6, 10}));
  EXPECT_EQ(LooksByTable(AlwaysCuboid(), 2, -1, Table(4)), (std::array{2, -2, -6}));
}

TEST(LooksByTable, NeverComeBackToASide) {
  // By the table 180 degrees and 180 degrees again; the nearest of what is left instead.
  EXPECT_EQ(LooksByTable(AlwaysCuboid(), 0, 1, Table(6)), (std::array{0, 6, 7}));
}

TEST(LooksByTable, TheThirdIsChosenByWhatTheFirstTwoSayTogether) {
  ViewRound round = AlwaysCuboid();
  round.views[2] = Look(0.1, 0.8, false);
  EXPECT_EQ(LooksByTable(round, 0, 1, Table(2)), (std::array{0, 2, 8}));
}

TEST(AnswersByTable, AreThoseOfTheLooksThatDoNotDecideBothWaysRound) {
  std::vector<ViewRound> rounds(3, AlwaysCuboid());
  rounds[1].views[0].decided = false;
  rounds[1].views[4] = Look(0.02, 0.9, true);
  const auto answers = AnswersByTable(rounds, Table(4));
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].round, 1U);
  EXPECT_FALSE(answers[0].two.right) << "0 and 4 say together: tapered";
  EXPECT_TRUE(answers[1].two.right) << "0 and -4 say the same";
}

TEST(AnswersByTable, AThirdLookIsTakenOnlyWhereTwoDoNotDecide) {
  const TableAnswers answers{0, {0.9, true}, {0.8, false}};
  EXPECT_TRUE(answers.Last(0.9).right);
  EXPECT_FALSE(answers.Last(0.95).right);
}

}  // namespace
}  // namespace geon::evaluation
