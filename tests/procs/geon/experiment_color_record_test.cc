#include "procs/geon/experiment_color_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "procs/geon/experiment_color_page.h"

namespace geon::cli {
namespace {

// Trials `first` to `last` of an experiment of two methods: the first finds all but every fifth.
ColorRecord Example(int first, int last) {
  ColorRecord record;
  record.seed = 3;
  record.git = "v1";
  record.conditions = {{"images", 40}};
  record.methods = {"taught", "super-red"};
  record.model = "name: taught\n";
  for (int t = first; t <= last; ++t) {
    ColorOutcome outcome;
    outcome.t = t;
    outcome.label = static_cast<GeonLabel>(t % kGeonLabelCount);
    outcome.kelvin = t % 2 == 0 ? 2700 : 10000;
    outcome.stops = t % 3 - 1;
    outcome.light = t % 4 == 0 ? "even" : "highlight";
    outcome.distractors = t % 2 == 1;
    outcome.target_pixels = 100 + t;
    outcome.scores = {{t % 5 != 0, t % 5 != 0 ? 0.9 + 0.001 * t : 0.0}, {false, 0.1}};
    AddWorstPicture({t, outcome.scores.front(), "data:image/jpeg;base64,AA=="}, &record.worst);
    record.outcomes.push_back(outcome);
  }
  return record;
}

TEST(ExperimentColorRecordTest, IsTheSameAfterWritingAndReading) {
  const ColorRecord record = Example(0, 9);
  const auto read = ParseColorRecord(nlohmann::json::parse(ColorRecordText(record)), "f");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(ColorRecordText(*read), ColorRecordText(record));
}

TEST(ExperimentColorRecordTest, RatesCountWhatTheTrialsSay) {
  const auto json = nlohmann::json::parse(ColorRecordText(Example(0, 9)));
  EXPECT_EQ(json.at("format"), "geon.experiment.v1");
  EXPECT_EQ(json.at("experiment"), "color");
  const auto& all = json.at("rates").at("taught").at("all");
  EXPECT_EQ(all.at("found"), 8);
  EXPECT_EQ(all.at("n"), 10);
  EXPECT_NEAR(all.at("median_iou").get<double>(), 0.904, 1e-9) << "the upper of the middle two";
  const auto& kelvin = json.at("rates").at("taught").at("colour of the lamp");
  EXPECT_EQ(kelvin.at("2700 K").at("n"), 5);
  EXPECT_EQ(json.at("rates").at("super-red").at("all").at("found"), 0);
  EXPECT_TRUE(json.at("seconds").is_null());
}

TEST(ExperimentColorRecordTest, ShardsInAnyOrderGiveTheSameBytes) {
  const auto joined = MergeColorRecords({Example(20, 39), Example(0, 19)});
  ASSERT_TRUE(joined.ok()) << joined.message();
  EXPECT_EQ(ColorRecordText(*joined), ColorRecordText(Example(0, 39)));
  ASSERT_EQ(joined->worst.size(), 12U);
  EXPECT_EQ(joined->worst.front().t, 0);
}

TEST(ExperimentColorRecordTest, ShardsOfOtherExperimentsAreRefused) {
  ColorRecord other = Example(5, 9);
  other.model = "name: other\n";
  EXPECT_FALSE(MergeColorRecords({Example(0, 4), other}).ok());
  EXPECT_FALSE(MergeColorRecords({Example(0, 4), Example(4, 9)}).ok()) << "trial 4 twice";
  EXPECT_FALSE(MergeColorRecords({}).ok());
}

TEST(ExperimentColorRecordTest, DamagedResultsAreRefused) {
  auto json = nlohmann::json::parse(ColorRecordText(Example(0, 9)));
  json["trials"][3]["scores"].erase(1);
  EXPECT_THAT(ParseColorRecord(json, "f").message(), testing::HasSubstr("trial 3"));
  EXPECT_FALSE(ParseColorRecord(nlohmann::json::object(), "f").ok());
}

TEST(ExperimentColorRecordTest, TablesAndPageNameEveryMethodAndLight) {
  const ColorRecord record = Example(0, 9);
  for (const std::string& text : {ColorTables(record), ColorPage(record)}) {
    for (const char* name : {"taught", "super-red", "2700 K", "+1 EV", "highlight", "ellipsoid"}) {
      EXPECT_THAT(text, testing::HasSubstr(name));
    }
  }
  EXPECT_THAT(ColorPage(record), testing::HasSubstr("not found, trial 0"));
  EXPECT_THAT(ColorPage(Example(1, 0)), testing::HasSubstr("No trials"));
}

}  // namespace
}  // namespace geon::cli
