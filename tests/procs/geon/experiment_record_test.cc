#include "procs/geon/experiment_record.h"

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
  EXPECT_TRUE(json.contains("seconds"));
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
