#include "procs/geon/navigation_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using lockstep::NavigationEnd;
using testing::ElementsAre;
using testing::HasSubstr;

NavigationTrialRecord Trial(int t, const std::string& world, NavigationEnd end) {
  NavigationTrialRecord trial;
  trial.t = t;
  trial.world = world;
  trial.seed = static_cast<uint64_t>(t) + 7;
  trial.end = end;
  trial.why = "because";
  trial.first_sight_s = 2.0;
  trial.end_s = 10.0 + t;
  trial.path_m = 3.0;
  return trial;
}

DrawnRun Map(int t) {
  DrawnRun map;
  map.t = t;
  map.pen_m = {3.0, 4.5};
  return map;
}

NavigationRecord Record(std::vector<NavigationTrialRecord> trials) {
  NavigationRecord record;
  record.planner = "map";
  record.git = "abc";
  record.conditions = {{"sensors", "real"}};
  record.trials = std::move(trials);
  return record;
}

NavigationRecord Mixed() {
  NavigationRecord record = Record({Trial(0, "boxes", NavigationEnd::kReached),
                                    Trial(1, "u_trap", NavigationEnd::kTrapped),
                                    Trial(2, "boxes", NavigationEnd::kReached)});
  record.trials[1].contacts = 2;
  record.trials[1].hardest_contact_m_s = 0.25;
  AddDrawnRun(Map(1), &record.maps);
  return record;
}

TEST(NavigationRecordTest, RatesCountEndsContactsAndTimes) {
  const auto rates = nlohmann::json::parse(NavigationRecordText(Mixed())).at("rates");
  EXPECT_EQ(rates.at("runs"), 3);
  EXPECT_EQ(rates.at("reached"), 2);
  EXPECT_EQ(rates.at("trapped"), 1);
  EXPECT_EQ(rates.at("unreachable"), 0);
  EXPECT_EQ(rates.at("none_found"), 0);
  EXPECT_EQ(rates.at("contacts"), 2);
  EXPECT_DOUBLE_EQ(rates.at("time_s").at("max"), 10.0) << "of those that got there";
  EXPECT_EQ(rates.at("worlds").at("boxes").at("runs"), 2);
}

TEST(NavigationRecordTest, NoneFoundIsRightWhereThereIsNone) {
  NavigationRecord record = Record(
      {Trial(0, "empty", NavigationEnd::kNoneFound), Trial(1, "boxes", NavigationEnd::kNoneFound)});
  record.trials[0].expected = NavigationEnd::kNoneFound;
  const NavigationSummary summary = Summarize(record, "");
  EXPECT_EQ(summary.none_found, 2);
  EXPECT_EQ(summary.right, 1);
  EXPECT_EQ(nlohmann::json::parse(NavigationRecordText(record)).at("rates").at("none_found"), 2);
  EXPECT_THAT(NavigationTables(record), HasSubstr("none found"));
  EXPECT_THAT(NavigationPage(record), HasSubstr("1 of 2 runs"));
}

// Two courses: one done in 20 s, 10 m of 10.2 driven and 0.2 left; one not done.
NavigationRecord Courses() {
  NavigationRecord record =
      Record({Trial(0, "dev", NavigationEnd::kReached), Trial(1, "dev", NavigationEnd::kTrapped)});
  for (NavigationTrialRecord& trial : record.trials) {
    trial.first_sight_s.reset();
    trial.end_s = 20.0;
    trial.path_m = 10.0;
    trial.course = CourseRecord{"world <3", 10.2, 5.0, 0.2};
  }
  return record;
}

TEST(NavigationRecordTest, CoursesAreMeasuredByTheShortestWayAndByBarnsMetric) {
  const NavigationRecord record = Courses();
  const NavigationSummary summary = Summarize(record);
  EXPECT_NEAR(summary.length_ratio_1.value(), 1.0, 1e-12) << "of the one that arrived";
  EXPECT_NEAR(summary.barn_score_1.value(), 0.5 * 5.0 / 20.0, 1e-12) << "of both";
  EXPECT_EQ(summary.times_s, std::vector<double>{20.0}) << "from the start";
  NavigationTrialRecord trial = record.trials[0];
  trial.end_s = 4.0;
  EXPECT_NEAR(trial.barn_score_1(), 0.5, 1e-12) << "no faster than twice the optimum";
  trial.end_s = 400.0;
  EXPECT_NEAR(trial.barn_score_1(), 0.125, 1e-12);
  EXPECT_FALSE(Summarize(Mixed()).barn_score_1.has_value());
}

TEST(NavigationRecordTest, CoursesAreInResultsTablesAndPage) {
  const std::string text = NavigationRecordText(Courses());
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("trials")[0].at("course").at("id"), "world <3");
  EXPECT_NEAR(json.at("rates").at("length_ratio_1").get<double>(), 1.0, 1e-12);
  const auto read = ParseNavigationRecord(json, "results.json");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(NavigationRecordText(*read), text);
  EXPECT_THAT(NavigationTables(*read), HasSubstr("from the start to the destination"));
  EXPECT_THAT(NavigationTables(*read), HasSubstr("1.000"));
  EXPECT_THAT(NavigationPage(*read), HasSubstr("world &lt;3"));
  EXPECT_THAT(NavigationPage(Mixed()), testing::Not(HasSubstr("Courses")));
}

TEST(NavigationRecordTest, WhatIsWrittenIsReadBack) {
  const std::string text = NavigationRecordText(Mixed());
  const auto read = ParseNavigationRecord(nlohmann::json::parse(text), "results.json");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(NavigationRecordText(*read), text);
}

TEST(NavigationRecordTest, DamagedResultsAreNamed) {
  auto value = nlohmann::json::parse(NavigationRecordText(Mixed()));
  value["trials"][0]["end"] = "flown away";
  const auto read = ParseNavigationRecord(value, "results.json");
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.message(), HasSubstr("results.json"));
  value["experiment"] = "bench";
  EXPECT_FALSE(ParseNavigationRecord(value, "x").ok());
}

TEST(NavigationRecordTest, ShardsJoinToTheBytesOfTheWhole) {
  const NavigationRecord whole = Mixed();
  NavigationRecord even = Record({whole.trials[0], whole.trials[2]});
  NavigationRecord odd = Record({whole.trials[1]});
  odd.maps = whole.maps;
  const auto joined = MergeNavigationRecords({odd, even});
  ASSERT_TRUE(joined.ok()) << joined.message();
  EXPECT_EQ(NavigationRecordText(*joined), NavigationRecordText(whole));
  even.planner = "thesis";
  EXPECT_FALSE(MergeNavigationRecords({odd, even}).ok());
}

TEST(NavigationRecordTest, TablesAndPageNameWorldsAndDrawWhatWentWrong) {
  const NavigationRecord record = Mixed();
  EXPECT_THAT(WorldsOf(record), ElementsAre("boxes", "u_trap"));
  EXPECT_THAT(NavigationTables(record), HasSubstr("u_trap"));
  const std::string page = NavigationPage(record);
  EXPECT_THAT(page, HasSubstr("2 of 3 runs"));
  EXPECT_THAT(page, HasSubstr("Map of run 1"));
  EXPECT_THAT(page, HasSubstr("trapped after 11.0 s"));
}

}  // namespace
}  // namespace geon::cli
