#include "procs/geon/experiment_color.h"

#include <gtest/gtest.h>

namespace geon::cli {
namespace {

void SayNothing(double) {}

TEST(ExperimentColorTest, JobsAndShardsGiveTheSameBytes) {
  const attention::ColorModel model = *attention::NamedColorModel("super-red");
  const ColorConditions conditions{5, 4, 1};
  const ColorRecord whole = RunColorTrials(model, conditions, {1, 1}, 2, SayNothing);
  std::vector<ColorRecord> shards;
  for (int index = 1; index <= 2; ++index) {
    shards.push_back(RunColorTrials(model, conditions, {index, 2}, 1, SayNothing));
  }
  const auto merged = MergeColorRecords(shards);
  ASSERT_TRUE(merged.ok()) << merged.message();
  EXPECT_EQ(ColorRecordText(*merged), ColorRecordText(whole));
  EXPECT_EQ(whole.methods.size(), 6U) << "each of the three, exposed and fixed";
}

TEST(ExperimentColorTest, TaughtColorFindsTheTargetInOtherScenes) {
  const ColorConditions conditions{5, 4, 6};
  const auto model = TeachOnScenes(conditions, SayNothing);
  ASSERT_TRUE(model.ok()) << model.message();
  const ColorRecord record = RunColorTrials(*model, conditions, {1, 1}, 1, SayNothing);
  int found = 0;
  for (const ColorOutcome& outcome : record.outcomes) found += outcome.scores[0].found ? 1 : 0;
  EXPECT_GE(found, 3) << "of 4";
}

}  // namespace
}  // namespace geon::cli
