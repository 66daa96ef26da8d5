#include "evaluation/train_forest.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "evaluation/random_scan.h"

namespace geon::evaluation {
namespace {

TrainingOptions Few() {
  TrainingOptions options;
  options.scans = 210;
  options.calibration_scans = 105;
  options.trees = 8;
  options.depth = 8;
  return options;
}

TEST(TrainForest, GivesTheSameBytesAgainAndLearnsSomething) {
  TrainingReport report, again;
  const OwnedForest forest = TrainForest(
      Few(), [](double) {}, &report);
  const OwnedForest same = TrainForest(
      Few(), [](double) {}, &again);
  EXPECT_EQ(ForestSource(forest, Few()), ForestSource(same, Few()));
  EXPECT_EQ(report.calibration_scans, 105);
  EXPECT_GT(report.right_1, 0.3) << "chance is one in seven";
  EXPECT_EQ(forest.roots.size(), 8U);
}

// With labels that say nothing the forest must not know better: scans hold no trace of their truth.
TEST(TrainForest, LearnsNothingFromShuffledLabels) {
  TrainingOptions options = Few();
  options.shuffle_labels = true;
  TrainingReport report;
  TrainForest(
      options, [](double) {}, &report);
  EXPECT_LT(report.right_1, 0.35);
}

TEST(TrainForest, WantsEnoughScans) {
  TrainingOptions options = Few();
  options.scans = 10;
  TrainingReport report;
  EXPECT_THROW(TrainForest(
                   options, [](double) {}, &report),
               ContractViolation);
}

TEST(StressedScans, AreTheSameWhenMadeAgainAndOfOneShape) {
  const auto a = MakeStressedScans(3, 5, 3), b = MakeStressedScans(3, 5, 3);
  ASSERT_EQ(a.size(), 3U);
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(a[k].scan.profiles[0].p_L_m, b[k].scan.profiles[0].p_L_m);
    EXPECT_EQ(a[k].scan.truth, a[0].shape.label);
  }
  EXPECT_NE(a[0].elevation_rad, a[1].elevation_rad);
}

}  // namespace
}  // namespace geon::evaluation
