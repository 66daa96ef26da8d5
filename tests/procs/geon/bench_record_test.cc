#include "procs/geon/bench_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using testing::HasSubstr;

BenchTrialRecord BenchTrialOf(int t, GeonLabel truth, std::optional<GeonLabel> answer,
                              double range_m) {
  BenchTrialRecord trial;
  trial.t = t;
  trial.subject = {truth, "1", 1};
  trial.range_m = range_m;
  trial.yaw_deg = 30.0 * t;
  trial.answer = answer;
  trial.confidence = answer ? 0.8 : 0.0;
  trial.decided = answer.has_value();
  trial.end = answer ? "the geon is named" : "the head did not come to rest";
  trial.from_sight_s = 5.0 + t;
  trial.from_view_s = 4.0 + t;
  trial.misplaced_1 = {0.01, -0.02};
  return trial;
}

// Two right, one wrong and one without an answer at 1.0 m, one right at 1.3 m.
BenchRecord FiveRuns() {
  BenchRecord record;
  record.method = "evidence";
  record.seed = 3;
  record.git = "test";
  record.conditions = {{"poses", 2}};
  record.trials = {
      BenchTrialOf(0, GeonLabel::kCuboid, GeonLabel::kCuboid, 1.0),
      BenchTrialOf(1, GeonLabel::kCuboid, GeonLabel::kTaperedCuboid, 1.0),
      BenchTrialOf(2, GeonLabel::kEllipsoid, GeonLabel::kEllipsoid, 1.0),
      BenchTrialOf(3, GeonLabel::kEllipsoid, std::nullopt, 1.0),
      BenchTrialOf(4, GeonLabel::kCuboid, GeonLabel::kCuboid, 1.3),
  };
  WorstView view{1, false, 0.8, {}, {"it leans"}, {}, "data:image/jpeg;base64,AA=="};
  AddWorstView(view, &record.worst);
  return record;
}

BenchRecord Part(const std::vector<size_t>& trials) {
  const BenchRecord all = FiveRuns();
  BenchRecord part = all;
  part.trials.clear();
  part.worst.clear();
  for (const size_t t : trials) {
    part.trials.push_back(all.trials[t]);
    if (t == 1) part.worst = all.worst;
  }
  return part;
}

TEST(BenchRecordTest, ARunWithoutAnAnswerIsWrong) {
  const auto ranges = BenchRanges(FiveRuns());
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].all.right, 2);
  EXPECT_EQ(ranges[0].all.n, 4);
  ASSERT_EQ(ranges[0].rows.size(), 2U);
  EXPECT_EQ(ranges[0].rows[1].n(), 1);
  EXPECT_EQ(ranges[0].unanswered[1], 1);
  EXPECT_EQ(ranges[1].all.right, 1);
}

TEST(BenchRecordTest, HoldsWhatTheContractAsksForAndIsTheSameAfterReading) {
  const std::string text = BenchRecordText(FiveRuns());
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("format"), "geon.experiment.v1");
  EXPECT_EQ(json.at("experiment"), "bench");
  EXPECT_EQ(json.at("cells")[0].at("range_m"), 1.0);
  EXPECT_EQ(json.at("cells")[0].at("n"), 2);
  EXPECT_EQ(json.at("cells")[0].at("counts").at("tapered_cuboid"), 1);
  EXPECT_TRUE(json.at("trials")[3].at("answer").is_null());
  const auto& rates = json.at("rates");
  EXPECT_EQ(rates.at("ranges")[0].at("right"), 2);
  EXPECT_EQ(rates.at("ranges")[0].at("classes").at("ellipsoid").at("n"), 2);
  EXPECT_EQ(rates.at("from_view_s").at("p50"), 5.0);  // of 4, 5, 6 and 8
  EXPECT_EQ(rates.at("misplaced").at("max"), 0.02);
  const auto read = ParseBenchRecord(json, "results.json");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(BenchRecordText(*read), text);
}

TEST(BenchRecordTest, ShardsMakeTheWholeInAnyOrderAndOthersAreRefused) {
  const auto whole = MergeBenchRecords({Part({1, 3}), Part({0, 2, 4})});
  ASSERT_TRUE(whole.ok()) << whole.message();
  EXPECT_EQ(BenchRecordText(*whole), BenchRecordText(FiveRuns()));
  EXPECT_THAT(MergeBenchRecords({Part({1}), Part({1, 2})}).message(), HasSubstr("trial 1"));
  BenchRecord other = Part({2});
  other.seed = 4;
  EXPECT_THAT(MergeBenchRecords({Part({1}), other}).message(), HasSubstr("shard 2"));
}

TEST(BenchRecordTest, DamagedResultsAreRefusedWithTheirName) {
  auto json = nlohmann::json::parse(BenchRecordText(FiveRuns()));
  json["trials"][0]["answer"] = "cube";
  EXPECT_THAT(ParseBenchRecord(json, "here.json").message(), HasSubstr("here.json"));
  json = nlohmann::json::parse(BenchRecordText(FiveRuns()));
  json["worst"][0]["t"] = 77;
  EXPECT_THAT(ParseBenchRecord(json, "here.json").message(), HasSubstr("77"));
}

}  // namespace
}  // namespace geon::cli
