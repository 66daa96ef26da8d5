#include "evaluation/train_forest.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/contracts.h"

namespace geon::evaluation {
namespace {

TrainingOptions Few() {
  TrainingOptions options;
  options.scans = 210;
  options.calibration_scans = 105;
  options.trees = 14;
  options.depth = 8;
  return options;
}

void OneByOne(double /*share_1*/, int count, const std::function<void(int)>& task) {
  for (int k = 0; k < count; ++k) task(k);
}

// Each task in a thread of its own, the last one first.
void LastFirstElsewhere(double /*share_1*/, int count, const std::function<void(int)>& task) {
  for (int k = count - 1; k >= 0; --k) std::thread(task, k).join();
}

TEST(TrainForest, GivesTheSameBytesInAnyOrderAndLearnsSomething) {
  TrainingReport report, again;
  const OwnedForest forest = TrainForest(Few(), OneByOne, &report);
  const OwnedForest same = TrainForest(Few(), LastFirstElsewhere, &again);
  EXPECT_EQ(ForestSource(forest, Few()), ForestSource(same, Few()));
  EXPECT_EQ(report.calibration_scans, 105);
  EXPECT_GT(report.right_1, 0.3) << "chance is one in seven";
  EXPECT_EQ(forest.roots.size(), 14U);
}

// With labels that say nothing the forest must not know better: scans hold no trace of their truth.
TEST(TrainForest, LearnsNothingFromShuffledLabels) {
  TrainingOptions options = Few();
  options.shuffle_labels = true;
  TrainingReport report;
  TrainForest(options, OneByOne, &report);
  EXPECT_LT(report.right_1, 0.35);
}

TEST(TrainForest, WantsEnoughScans) {
  TrainingOptions options = Few();
  options.scans = 10;
  TrainingReport report;
  EXPECT_THROW(TrainForest(options, OneByOne, &report), ContractViolation);
}

}  // namespace
}  // namespace geon::evaluation
