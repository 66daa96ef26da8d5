#include "procs/geon/experiment_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "config/daemon_arguments.h"
#include "sim/world_file.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;

class ExperimentRobotTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  // Distances come from the rig: the look-up tables take long to load.
  RobotRecord Run(const RobotPlan& plan, Shard shard, int jobs) const {
    RobotRecord record;
    record.conditions = nlohmann::json::object();
    const auto cases = RobotCases(plan, settings_->sim, shard);
    EXPECT_TRUE(cases.ok()) << cases.message();
    const Status run = RunRobotCases(
        *settings_, std::nullopt, *cases, plan.longest_s, jobs, [](double) {}, &record);
    EXPECT_TRUE(run.ok()) << run.message();
    return record;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / "experiment_robot_test";
  const Result<lockstep::LockstepSettings> settings_ =
      lockstep::LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                                     config::InstalledFile("scripts/config/sim.yaml"));
};

TEST_F(ExperimentRobotTest, OfAnyPlaceExactlyHalfAreOnTheFloor) {
  RobotPlan plan;
  plan.runs = 6;
  plan.seed = 11;
  const auto cases = RobotCases(plan, {}, {});
  ASSERT_TRUE(cases.ok());
  ASSERT_EQ(cases->size(), 6U);
  for (const RobotCase& each : *cases) {
    EXPECT_EQ(each.seed, 11U + static_cast<uint64_t>(each.t));
    EXPECT_EQ(sim::FootHeight(each.world, each.world.objects.back()) > 0.0, each.t % 2 == 1);
  }
  plan.place = sim::GeonPlace::kBox;
  const auto boxes = RobotCases(plan, {}, {2, 3});
  ASSERT_EQ(boxes->size(), 2U);
  for (const RobotCase& each : *boxes) {
    EXPECT_TRUE(each.t == 1 || each.t == 4);
    EXPECT_GT(sim::FootHeight(each.world, each.world.objects.back()), 0.0);
  }
}

TEST_F(ExperimentRobotTest, ARunComesAgainFromTheFileOfItsWorld) {
  RobotPlan random;
  random.runs = 1;
  random.seed = 21;
  random.longest_s = 1.0;
  RobotPlan written = random;
  written.worlds = {
      Write("pen.yaml", sim::WorldText(sim::RandomWorld(21, sim::GeonPlace::kFloor)))};
  const RobotRecord first = Run(random, {}, 1);
  RobotRecord again = Run(written, {}, 1);
  ASSERT_EQ(again.trials.size(), 1U);
  EXPECT_EQ(again.trials[0].world, "pen.yaml");
  again.trials[0].world.clear();
  EXPECT_EQ(RobotRecordText(again), RobotRecordText(first));
}

TEST_F(ExperimentRobotTest, JobsAndShardsGiveTheBytesOfOneRun) {
  RobotPlan plan;
  plan.runs = 3;
  plan.longest_s = 3.0;  // until the search has begun
  const RobotRecord whole = Run(plan, {}, 1);
  ASSERT_EQ(whole.trials.size(), 3U);
  EXPECT_EQ(whole.trials[2].end, sensor::MissionOutcome::kRunning);
  EXPECT_EQ(whole.maps.size(), 3U);
  ASSERT_TRUE(whole.film.has_value() && !whole.film->stills.empty());
  EXPECT_THAT(whole.film->stills.back().picture_uri, testing::StartsWith("data:image/jpeg"));
  const auto merged = MergeRobotRecords({Run(plan, {2, 2}, 1), Run(plan, {1, 2}, 2)});
  ASSERT_TRUE(merged.ok()) << merged.message();
  EXPECT_EQ(RobotRecordText(*merged), RobotRecordText(whole));
  EXPECT_EQ(RobotPage(*merged), RobotPage(whole));
}

TEST_F(ExperimentRobotTest, WorldsWithoutAGeonOrWithAnUnnamedMeshAreRefusedByName) {
  const std::string pen =
      "pen: {size_m: [3.0, 4.5]}\nrobot: {x_m: 0.5, y_m: 0.5}\nobjects:\n"
      "  - {box: [0.4, 0.4, 0.7], x_m: 2.0, y_m: 2.0}\n";
  RobotPlan plan;
  plan.worlds = {Write("empty.yaml", pen)};
  EXPECT_THAT(RobotCases(plan, {}, {}).message(), HasSubstr("empty.yaml: there is no geon"));
  plan.worlds = {
      Write("mesh.yaml", pen + "  - {mesh: banana.obj, height_m: 0.2, x_m: 1.0, y_m: 3.0}\n")};
  EXPECT_THAT(RobotCases(plan, {}, {}).message(), HasSubstr("mesh.yaml: a mesh without `truth`"));
  plan.worlds = {Write(
      "named.yaml",
      pen + "  - {mesh: banana.obj, height_m: 0.2, x_m: 1.0, y_m: 3.0, truth: bent_cylinder}\n")};
  const auto cases = RobotCases(plan, {}, {});
  ASSERT_TRUE(cases.ok()) << cases.message();
  RobotRecord record;
  const Status run = RunRobotCases(
      *settings_, std::nullopt, *cases, 1.0, 1, [](double) {}, &record);
  EXPECT_THAT(run.message(), HasSubstr("banana.obj")) << "it is not there";
}

}  // namespace
}  // namespace geon::cli
