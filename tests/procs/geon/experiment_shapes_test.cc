#include "procs/geon/experiment_shapes.h"

#include <gtest/gtest.h>

#include "geons/polygon_geon.h"
#include "procs/geon/experiment_page.h"
#include "procs/geon/experiment_record.h"
#include "recognition/recognize_geon.h"

namespace geon::cli {
namespace {

std::vector<ShownObject> TwoObjects() {
  const geons::GeonShape box{GeonLabel::kCuboid, {0.10, 0.12, 0.14}};
  const geons::GeonShape can{GeonLabel::kCylinder, {0.12, 0.12, 0.14}};
  return {{{box.label, "box", 1}, geons::PolygonGeon(box, 32)},
          {{can.label, "can", 1}, geons::PolygonGeon(can, 32)}};
}

ShapeRecord Record(Shard shard, int jobs) {
  ShapeRecord record;
  record.method = "evidence";
  record.git = "test";
  record.conditions = {{"range_m", 1.0}};
  const std::vector<ShownObject> objects = TwoObjects();
  for (const ShownObject& object : objects) record.subjects.push_back(object.subject);
  std::vector<evaluation::ViewingCell> sphere = evaluation::ViewingSphere();
  sphere.resize(9);
  ShapeRun run = RunShapeTrials(
      objects, sphere, {},
      [](const sensor::ScanSet& scan) { return recognition::RecognizeGeon(scan, {}); }, shard,
      jobs);
  record.trials = std::move(run.trials);
  record.worst = std::move(run.worst);
  return record;
}

TEST(RunShapeTrials, JobsDoNotChangeAByte) {
  const ShapeRecord one = Record({1, 1}, 1);
  EXPECT_EQ(one.trials.size(), 18U);
  const ShapeRecord three = Record({1, 1}, 3);
  EXPECT_EQ(RecordText(three), RecordText(one));
  EXPECT_EQ(ExperimentPage(three), ExperimentPage(one));
}

TEST(RunShapeTrials, ShardsJoinedAreTheWholeInAnyOrder) {
  std::vector<ShapeRecord> shards;
  for (int index : {3, 1, 2}) shards.push_back(Record({index, 3}, 1));
  const Result<ShapeRecord> joined = MergeRecords(shards);
  ASSERT_TRUE(joined.ok()) << joined.message();
  const ShapeRecord whole = Record({1, 1}, 1);
  EXPECT_FALSE(whole.worst.empty());
  EXPECT_EQ(RecordText(*joined), RecordText(whole));
  EXPECT_EQ(ExperimentPage(*joined), ExperimentPage(whole));
}

// With shuffled labels a recogniser is right by chance: the path from file to rate leaks nothing.
TEST(RunShapeTrials, ARecognizerThatDoesNotLookIsRightByChance) {
  int answer = 0;
  std::vector<ShownObject> objects = TwoObjects();
  const ShapeRun run = RunShapeTrials(
      objects, evaluation::ViewingSphere(), {},
      [&answer](const sensor::ScanSet& scan) {
        EXPECT_FALSE(scan.truth.has_value());
        sensor::GeonVerdict verdict;
        verdict.label = static_cast<GeonLabel>(++answer % kGeonLabelCount);
        return verdict;
      },
      {}, 1);
  std::vector<evaluation::Subject> subjects = {objects[0].subject, objects[1].subject};
  const auto rate = evaluation::OverallRate(evaluation::CountAnswers(subjects, run.trials));
  EXPECT_NEAR(rate.value_1(), 1.0 / 7.0, 0.01);
}

}  // namespace
}  // namespace geon::cli
