#include "procs/geon/experiment_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::cli {
namespace {

ShapeRecord Example(int first, int count) {
  ShapeRecord record;
  record.method = "thesis";
  record.seed = 3;
  record.git = "abc";
  record.conditions = {{"range_m", 1.3}, {"stress", "none"}};
  record.subjects = {{GeonLabel::kCuboid, "1", 1}, {GeonLabel::kEllipsoid, "2", 1}};
  for (int t = first; t < first + count; ++t) {
    record.trials.push_back({t,
                             t % 2,
                             {RadiansFromDegrees(35), RadiansFromDegrees(5 + 10 * t)},
                             GeonLabel::kCuboid,
                             0.25,
                             t % 3 != 0});
  }
  for (const evaluation::ShapeTrial& trial : record.trials) {
    const bool right = trial.answer == record.subjects[static_cast<size_t>(trial.subject)].truth;
    AddWorstView({trial.t, right, trial.confidence, {}, {"because"}, {}, {}}, &record.worst);
  }
  return record;
}

Result<ShapeRecord> Read(const std::string& text) {
  return ParseRecord(nlohmann::json::parse(text), "results.json");
}

TEST(ExperimentRecordTest, IsTheSameAfterWritingAndReading) {
  const ShapeRecord record = Example(0, 6);
  const Result<ShapeRecord> read = Read(RecordText(record));
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(RecordText(*read), RecordText(record));
}

TEST(ExperimentRecordTest, HoldsWhatTheContractAsksFor) {
  const auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  EXPECT_EQ(json.at("format"), "geon.experiment.v1");
  EXPECT_EQ(json.at("experiment"), "shapes");
  ASSERT_EQ(json.at("cells").size(), 2U);
  const auto& cell = json.at("cells")[0];
  EXPECT_EQ(cell.at("truth"), "cuboid");
  EXPECT_EQ(cell.at("n"), 3);
  EXPECT_EQ(cell.at("counts").at("cuboid"), 3);
  EXPECT_EQ(cell.at("undecided"), 1);
  EXPECT_EQ(cell.at("range_m"), 1.3);
  EXPECT_EQ(json.at("trials").size(), 6U);
  EXPECT_EQ(json.at("rates").at("all").at("right"), 3);
  EXPECT_NEAR(json.at("rates").at("mean_of_cells").get<double>(), 0.5, 1e-12);
  EXPECT_TRUE(json.at("seconds").is_null());
}

TEST(ExperimentRecordTest, HoldsHowFarTheConfidenceIsToBeBelieved) {
  const auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  const auto& rates = json.at("rates");
  EXPECT_EQ(rates.at("classes").at("cuboid").at("n"), 3);
  ASSERT_EQ(rates.at("rows").size(), 2U);
  EXPECT_EQ(rates.at("rows")[1].at("truth"), "ellipsoid");
  EXPECT_EQ(rates.at("rows")[1].at("object"), "2");
  EXPECT_EQ(rates.at("rows")[1].at("right"), 0);
  EXPECT_EQ(rates.at("rows")[1].at("wilson95").size(), 2U);
  ASSERT_EQ(rates.at("elevations").size(), 1U);
  EXPECT_EQ(rates.at("elevations")[0].at("elevation_deg"), 35);
  EXPECT_EQ(rates.at("elevations")[0].at("n"), 6);
  EXPECT_EQ(rates.at("decided").at("decided"), 4);
  EXPECT_EQ(rates.at("decided").at("n"), 6);
  EXPECT_EQ(rates.at("decided_right").at("right"), 2);  // trials 2 and 4
  EXPECT_EQ(rates.at("decided_right").at("n"), 4);
  EXPECT_NEAR(rates.at("expected_calibration_error").get<double>(), 0.25, 1e-12);
  ASSERT_EQ(rates.at("reliability").size(), 15U);
  EXPECT_EQ(rates.at("reliability")[3].at("n"), 6);
  EXPECT_EQ(rates.at("reliability")[3].at("mean_confidence"), 0.25);
  EXPECT_TRUE(rates.at("reliability")[0].at("mean_confidence").is_null());
}

TEST(ExperimentRecordTest, KeepsTheWorstOfAllShards) {
  const auto joined = MergeRecords({Example(20, 20), Example(0, 20)});
  ASSERT_TRUE(joined.ok()) << joined.message();
  EXPECT_EQ(RecordText(*joined), RecordText(Example(0, 40)));
  ASSERT_EQ(joined->worst.size(), kMostWorstViews);
  EXPECT_EQ(joined->worst.front().t, 1);  // the first ellipsoid called a cuboid
}

TEST(ExperimentRecordTest, RecordsWithoutViewsAreReadToo) {
  auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  json.erase("worst");
  const auto record = Read(json.dump());
  ASSERT_TRUE(record.ok()) << record.message();
  EXPECT_TRUE(record->worst.empty());
  json["worst"] = {{{"t", 99}, {"posterior", {}}, {"reasons", {}}, {"stripes", {}}}};
  EXPECT_FALSE(Read(json.dump()).ok());
}

TEST(ExperimentRecordTest, ConfidenceBeyondCertaintyIsDamage) {
  auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  json["trials"][2]["confidence"] = 1.5;
  EXPECT_THAT(Read(json.dump()).message(), testing::HasSubstr("within 0 and 1"));
}

TEST(ExperimentRecordTest, ShardsOfDifferentExperimentsAreNotMerged) {
  ShapeRecord other = Example(3, 3);
  EXPECT_TRUE(MergeRecords({Example(0, 3), other}).ok());
  other.seed = 4;
  EXPECT_FALSE(MergeRecords({Example(0, 3), other}).ok());
  other = Example(3, 3);
  other.conditions["range_m"] = 1.6;
  EXPECT_FALSE(MergeRecords({Example(0, 3), other}).ok());
  EXPECT_FALSE(MergeRecords({Example(0, 3), Example(2, 3)}).ok());  // trial 2 twice
  EXPECT_FALSE(MergeRecords({}).ok());
}

TEST(ExperimentRecordTest, DamagedResultsAreRefusedWithTheirName) {
  for (const char* text : {"{}", R"({"format":"geon.experiment.v1","experiment":"shapes"})"}) {
    const Result<ShapeRecord> read = Read(text);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.message().find("results.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace geon::cli
