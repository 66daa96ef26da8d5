#include "procs/geon/experiment_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"
#include "config/text_file.h"

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
    AddWorstView({trial.t, right, trial.confidence, {}, {"because"}, {}}, &record.worst);
  }
  return record;
}

class ExperimentRecordTest : public testing::Test {
 protected:
  ExperimentRecordTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {}
  ~ExperimentRecordTest() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_;
};

TEST_F(ExperimentRecordTest, IsTheSameAfterWritingAndReading) {
  const ShapeRecord record = Example(0, 6);
  ASSERT_TRUE(WriteRecord(record, 1.5, folder_).ok());
  const Result<ShapeRecord> read = LoadRecord(folder_ / "results.json");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(RecordText(*read), RecordText(record));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "timing.json"));
}

TEST_F(ExperimentRecordTest, HoldsWhatTheContractAsksFor) {
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

TEST_F(ExperimentRecordTest, HoldsHowFarTheConfidenceIsToBeBelieved) {
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

TEST_F(ExperimentRecordTest, KeepsTheWorstOfAllShards) {
  const auto joined = MergeRecords({Example(20, 20), Example(0, 20)});
  ASSERT_TRUE(joined.ok()) << joined.message();
  EXPECT_EQ(RecordText(*joined), RecordText(Example(0, 40)));
  ASSERT_EQ(joined->worst.size(), kMostWorstViews);
  EXPECT_EQ(joined->worst.front().t, 1);  // the first ellipsoid called a cuboid
}

TEST_F(ExperimentRecordTest, RecordsWithoutViewsAreReadToo) {
  auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  json.erase("worst");
  std::filesystem::create_directories(folder_);
  const std::filesystem::path file = folder_ / "results.json";
  ASSERT_TRUE(config::WriteFileAtomically(file, json.dump()).ok());
  const auto record = LoadRecord(file);
  ASSERT_TRUE(record.ok()) << record.message();
  EXPECT_TRUE(record->worst.empty());
  json["worst"] = {{{"t", 99}, {"posterior", {}}, {"reasons", {}}, {"stripes", {}}}};
  ASSERT_TRUE(config::WriteFileAtomically(file, json.dump()).ok());
  EXPECT_FALSE(LoadRecord(file).ok());
}

TEST_F(ExperimentRecordTest, ConfidenceBeyondCertaintyIsDamage) {
  auto json = nlohmann::json::parse(RecordText(Example(0, 6)));
  json["trials"][2]["confidence"] = 1.5;
  std::filesystem::create_directories(folder_);
  const std::filesystem::path file = folder_ / "results.json";
  ASSERT_TRUE(config::WriteFileAtomically(file, json.dump()).ok());
  EXPECT_THAT(LoadRecord(file).message(), testing::HasSubstr("within 0 and 1"));
}

TEST_F(ExperimentRecordTest, ShardsOfDifferentExperimentsAreNotMerged) {
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

TEST_F(ExperimentRecordTest, DamagedFilesAreRefusedWithTheirName) {
  std::filesystem::create_directories(folder_);
  const std::filesystem::path file = folder_ / "results.json";
  for (const char* text : {"{", "{}", R"({"format":"geon.experiment.v1","experiment":"shapes"})"}) {
    ASSERT_TRUE(config::WriteFileAtomically(file, text).ok());
    const Result<ShapeRecord> read = LoadRecord(file);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.message().find("results.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace geon::cli
