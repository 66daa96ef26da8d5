#include "procs/geon/robot_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using sensor::MissionOutcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

RobotTrialRecord RobotTrial(int t, MissionOutcome end, std::optional<GeonLabel> label) {
  RobotTrialRecord trial;
  trial.t = t;
  trial.seed = static_cast<uint64_t>(t) + 7;
  trial.subject = {GeonLabel::kCuboid, t % 2 == 0 ? "floor" : "box", 1};
  trial.end = end;
  trial.label = label;
  trial.decided = end == MissionOutcome::kNamed;
  trial.confidence = label ? 0.9 : 0.0;
  trial.views = label ? 1 : 0;
  trial.why = "because of run " + std::to_string(t);
  trial.first_sight_s = 2.0;
  trial.end_s = 10.0 + t;
  trial.path_m = 3.0;
  return trial;
}

DrawnRun MapOf(int t) {
  DrawnRun run;
  run.t = t;
  run.pen_m = {3.0, 4.5};
  run.path_m = {{0.5, 0.5}, {1.0, 1.0}};
  run.picture_uri = "data:image/jpeg;base64,BB" + std::to_string(t);
  return run;
}

// On the floor: right, a right guess, trapped. On the box: taken for a cylinder, unreachable.
RobotRecord FiveMissions() {
  RobotRecord record;
  record.method = "evidence";
  record.seed = 7;
  record.git = "abc";
  record.conditions = {{"planner", "map"}, {"scan", "stop"}};
  record.trials = {RobotTrial(0, MissionOutcome::kNamed, GeonLabel::kCuboid),
                   RobotTrial(1, MissionOutcome::kNamed, GeonLabel::kCylinder),
                   RobotTrial(2, MissionOutcome::kFailed, GeonLabel::kCuboid),
                   RobotTrial(3, MissionOutcome::kUnreachable, std::nullopt),
                   RobotTrial(4, MissionOutcome::kRunning, std::nullopt)};
  record.trials[4].contacts = 2;
  record.trials[4].hardest_contact_m_s = 0.25;
  for (int t = 1; t < 5; ++t) AddDrawnRun(MapOf(t), &record.maps);
  record.film = RobotFilm{MapOf(0),
                          {{0.1, "search", "all devices answer", {0.5, 0.5}, ""},
                           {10.0, "done", "the geon is a cuboid", {1.0, 1.0}, "data:image/jpeg"}}};
  return record;
}

RobotRecord ShardOf(const std::vector<size_t>& trials) {
  const RobotRecord all = FiveMissions();
  RobotRecord shard = all;
  shard.trials.clear();
  shard.maps.clear();
  shard.film.reset();
  for (const size_t t : trials) {
    shard.trials.push_back(all.trials[t]);
    if (t > 0) AddDrawnRun(MapOf(static_cast<int>(t)), &shard.maps);
    if (t == 0) shard.film = all.film;
  }
  return shard;
}

TEST(RobotRecordTest, EveryOutcomeOfAMissionHasItsWord) {
  for (const auto outcome : {MissionOutcome::kRunning, MissionOutcome::kNamed,
                             MissionOutcome::kFailed, MissionOutcome::kUnreachable}) {
    EXPECT_EQ(sensor::MissionOutcomeFromString(ToString(outcome)), outcome);
  }
  EXPECT_FALSE(sensor::MissionOutcomeFromString("lost").has_value());
}

TEST(RobotRecordTest, EveryRunIsRightWrongUndecidedTrappedOrUnreachable) {
  const auto rates = nlohmann::json::parse(RobotRecordText(FiveMissions())).at("rates");
  EXPECT_EQ(rates.at("runs"), 5);
  EXPECT_EQ(rates.at("right"), 1) << "a guess is not right, even where it is";
  EXPECT_EQ(rates.at("right_guess"), 1);
  EXPECT_EQ(rates.at("wrong"), 1);
  EXPECT_EQ(rates.at("undecided"), 1);
  EXPECT_EQ(rates.at("trapped"), 1);
  EXPECT_EQ(rates.at("unreachable"), 1);
  EXPECT_EQ(rates.at("reached"), 3);
  EXPECT_EQ(rates.at("contacts"), 2);
  EXPECT_EQ(rates.at("hardest_contact_m_s"), 0.25);
  EXPECT_EQ(rates.at("time_s").at("max"), 12.0) << "of those that came to a verdict";
  EXPECT_NEAR(rates.at("wilson95")[1], 0.62, 0.01);
  EXPECT_EQ(rates.at("places").at("floor").at("runs"), 3);
  EXPECT_EQ(rates.at("places").at("box").at("right"), 0);
}

TEST(RobotRecordTest, HoldsWhatTheContractAsksForAndIsTheSameAfterReading) {
  const std::string text = RobotRecordText(FiveMissions());
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("format"), "geon.experiment.v1");
  EXPECT_EQ(json.at("experiment"), "robot");
  EXPECT_TRUE(json.at("seconds").is_null());
  EXPECT_EQ(json.at("cells")[0].at("truth"), "cuboid");
  EXPECT_EQ(json.at("cells")[0].at("object"), "floor");
  EXPECT_EQ(json.at("cells")[0].at("n"), 3);
  EXPECT_EQ(json.at("cells")[0].at("counts").at("cuboid"), 2);
  EXPECT_EQ(json.at("cells")[0].at("undecided"), 2);
  EXPECT_EQ(json.at("trials")[4].at("end"), "running");
  EXPECT_TRUE(json.at("trials")[4].at("label").is_null());
  EXPECT_EQ(json.at("trials")[1].at("place"), "box");
  const auto read = ParseRobotRecord(json, "results.json");
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(RobotRecordText(*read), text);
}

TEST(RobotRecordTest, ShardsMakeTheWholeInAnyOrderAndOthersAreRefused) {
  const auto whole = MergeRobotRecords({ShardOf({1, 3}), ShardOf({0, 2, 4})});
  ASSERT_TRUE(whole.ok()) << whole.message();
  EXPECT_EQ(RobotRecordText(*whole), RobotRecordText(FiveMissions()));
  EXPECT_EQ(RobotPage(*whole), RobotPage(FiveMissions()));
  EXPECT_THAT(MergeRobotRecords({ShardOf({1}), ShardOf({1, 2})}).message(), HasSubstr("trial 1"));
  RobotRecord other = ShardOf({2});
  other.method = "thesis";
  EXPECT_THAT(MergeRobotRecords({ShardOf({1}), other}).message(), HasSubstr("shard 2"));
}

TEST(RobotRecordTest, DamagedResultsAreRefusedWithTheirName) {
  auto json = nlohmann::json::parse(RobotRecordText(FiveMissions()));
  json["trials"][0]["end"] = "flown away";
  EXPECT_THAT(ParseRobotRecord(json, "here.json").message(), HasSubstr("here.json"));
  json["experiment"] = "bench";
  EXPECT_THAT(ParseRobotRecord(json, "here.json").message(), HasSubstr("not the results of"));
}

TEST(RobotTablesTest, StandBesideTheThesisByPlace) {
  const auto rows = RobotTable(FiveMissions());
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[1],
              ElementsAre("the floor", "3", "1: 33.3 % (6.1-79.2)", "47 % of 15", "0",
                          "1 (1 right)", "1", "0", "2 (0.25 m/s)", "10.0", "12.0", "12.0"));
  EXPECT_THAT(rows[2], ElementsAre("the box", "2", "0: 0.0 % (0.0-65.8)", "73 % of 15", "1", "0",
                                   "0", "1", "0", "11.0", "11.0", "11.0"));
  EXPECT_EQ(rows[3][3], "60 % of 30");
  const std::string text = RobotTables(FiveMissions());
  EXPECT_THAT(text, HasSubstr("method evidence, planner map, scan stop"));
  EXPECT_THAT(text, HasSubstr("within 30 seconds"));
  EXPECT_EQ(RobotTable(ShardOf({1, 3})).size(), 2U) << "one place needs no sum";
}

TEST(RobotPageTest, ShowsTheFilmAndWhatWentWrong) {
  const std::string page = RobotPage(FiveMissions());
  EXPECT_THAT(page, HasSubstr("1 of 5 missions named the geon rightly"));
  EXPECT_THAT(page, HasSubstr("<b>2. done</b> at 10.0 s"));
  EXPECT_THAT(page, HasSubstr("class=\"blank\"")) << "a still without a new picture";
  EXPECT_THAT(page, HasSubstr("Run 1, seed 8: a cuboid on the box, taken for a cylinder"));
  EXPECT_THAT(page, HasSubstr("Run 2, seed 9: a cuboid on the floor, perhaps a cuboid"));
  EXPECT_THAT(page, HasSubstr("Run 3, seed 10: a cuboid on the box, said to be out of reach"));
  EXPECT_THAT(page, HasSubstr("because of run 4"));
  EXPECT_THAT(page, HasSubstr("base64,BB3"));
  EXPECT_THAT(page, HasSubstr("2 geons have none"));
}

TEST(RobotPageTest, ASurveyThatIsNotAllRightSaysHowManyOfItsGeonsAre) {
  RobotRecord record = ShardOf({4});
  RobotTrialRecord& survey = record.trials[0];
  survey.end = MissionOutcome::kSurveyed;
  survey.geons = {{GeonLabel::kCuboid, "floor", true, GeonLabel::kCuboid, true, 1, 0.02},
                  {GeonLabel::kCylinder, "floor", true, GeonLabel::kEllipsoid, true, 1, 0.03}};
  survey.others = 1;
  const std::string page = RobotPage(record);
  EXPECT_THAT(page, HasSubstr("1 of 2 geons rightly named, 1 findings where there is none"));
  EXPECT_THAT(page, HasSubstr("missions named all their geons rightly"));
  EXPECT_THAT(page, HasSubstr("0 geons have none")) << "both are in the table of answers";
  EXPECT_EQ(Summarize(record).wrong, 1) << "it ended with an answer";
  EXPECT_EQ(Summarize(record).undecided, 0);
}

TEST(RobotSummaryTest, ASurveyWhoseTimeWasOverIsRightOrTrappedButNotBoth) {
  RobotRecord record = ShardOf({4});
  RobotTrialRecord& survey = record.trials[0];
  survey.end = MissionOutcome::kFailed;
  survey.label.reset();
  survey.others = 0;
  survey.geons = {{GeonLabel::kCuboid, "floor", true, GeonLabel::kCuboid, true, 1, 0.02},
                  {GeonLabel::kCylinder, "floor", true, GeonLabel::kCylinder, true, 1, 0.03}};
  EXPECT_EQ(Summarize(record).right.right, 1);
  EXPECT_EQ(Summarize(record).trapped, 0);
  survey.geons[1].label.reset();
  EXPECT_EQ(Summarize(record).right.right, 0);
  EXPECT_EQ(Summarize(record).trapped, 1);
}

TEST(RobotPageTest, NeedsNothingFromElsewhereAndSaysWhenNothingIsWrong) {
  EXPECT_THAT(RobotPage(FiveMissions()), Not(HasSubstr("<script")));
  EXPECT_THAT(RobotPage(FiveMissions()), Not(HasSubstr("http")));
  EXPECT_THAT(RobotPage(ShardOf({0})), HasSubstr("every geon was named rightly"));
  EXPECT_THAT(RobotPage({}), HasSubstr("No runs"));
}

}  // namespace
}  // namespace geon::cli
