#include "procs/planner/planner_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/angles.h"

namespace geon::planner {
namespace {

using testing::HasSubstr;

const std::filesystem::path kRobotFile =
    std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml";

// The planner's section of the shipped robot file, with `from` replaced by `to`.
Status ReadWith(const std::string& from, const std::string& to, mission::MissionOptions* options) {
  std::ifstream file(kRobotFile);
  std::stringstream text;
  text << file.rdbuf();
  std::string yaml = text.str();
  yaml = yaml.substr(yaml.find("\nplanner:"));
  yaml = yaml.substr(0, yaml.find("\nrecognizer:"));
  const size_t at = yaml.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  yaml.replace(at, from.size(), to);
  auto document = config::YamlDocument::Parse(yaml, "robot.yaml");
  ReadPlannerSection(document->root().Child("planner"), kRobotFile, options);
  return document->Finish();
}

TEST(PlannerConfigTest, TheShippedFileIsGood) {
  mission::MissionOptions options;
  const Status status = ReadWith("seed: 1", "seed: 9", &options);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(options.seed, 9U);
  EXPECT_NEAR(options.driving.velocity.max_turn_rate_rad_s, RadiansFromDegrees(60.0), 1e-12);
  EXPECT_NEAR(options.looking.sweep.pan_max_rad, RadiansFromDegrees(60.0), 1e-12);
  EXPECT_EQ(options.looking.support_heights_m.size(), 2U);
}

TEST(PlannerConfigTest, InventoryAndViewsAreReadAndMayBeLeftOut) {
  mission::MissionOptions options;
  Status status = ReadWith("inventory: false", "inventory: true", &options);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_TRUE(options.inventory);
  EXPECT_EQ(options.patience.views, 3);
  options = {};
  status = ReadWith("views: 3 ", "views: 5 ", &options);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_FALSE(options.inventory);
  EXPECT_EQ(options.patience.views, 5);
  // As files from before are.
  options = {};
  status = ReadWith("inventory: false", "", &options);
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_FALSE(options.inventory);
  status = ReadWith("views: 3 ", "# ", &options);
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(options.patience.views, mission::PatienceOptions().views);
  EXPECT_THAT(ReadWith("views: 3 ", "views: 0 ", &options).message(), HasSubstr("views"));
}

TEST(PlannerConfigTest, ADestinationMayBeGiven) {
  mission::MissionOptions options;
  ASSERT_TRUE(ReadWith("seed: 1", "seed: 2", &options).ok());
  EXPECT_FALSE(options.destination_W_m.has_value());
  const Status status = ReadWith("seed: 1", "destination_m: [4.5, -1.0]\n  seed: 1", &options);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(options.destination_W_m, Eigen::Vector2d(4.5, -1.0));
  options = {};
  EXPECT_THAT(ReadWith("seed: 1", "destination_m: [4.5]\n  seed: 1", &options).message(),
              HasSubstr("destination_m"));
  options = {};
  EXPECT_THAT(ReadWith("seed: 1", "destination_m: [0, 40]\n  seed: 1", &options).message(),
              HasSubstr("must lie within"));
}

TEST(PlannerConfigTest, ToTakesThePlaceOfTheFilesDestination) {
  const auto sent = [](const std::string& to) {
    config::DaemonArguments arguments("geon-planner", "", "");
    arguments.config_file = kRobotFile;
    return LoadPlannerConfig(arguments, to);
  };
  EXPECT_FALSE(sent("")->mission.destination_W_m.has_value());
  EXPECT_EQ(sent("-1.5,2")->mission.destination_W_m, Eigen::Vector2d(-1.5, 2.0));
  for (const std::string wrong : {"2", "2;3", "2,3m", "2,", "a,b"}) {
    EXPECT_THAT(sent(wrong).status().message(),
                testing::AllOf(HasSubstr("--to " + wrong), HasSubstr("X,Y")));
  }
  EXPECT_THAT(sent("30,0").status().message(), HasSubstr("must lie within"));
}

TEST(PlannerConfigTest, ADeadPlannersRobotStandsInTime) {
  mission::MissionOptions options;
  ASSERT_TRUE(ReadWith("seed: 1", "seed: 2", &options).ok());
  // 0.15 s until the base lets a command lapse, 0.05 s to its motors, and braking at 1.5 m/s^2.
  EXPECT_LE(0.15 + 0.05 + options.driving.velocity.max_speed_m_s / 1.5, 0.5);
}

TEST(PlannerConfigTest, RefusalsNameFileLineAndRule) {
  mission::MissionOptions options;
  EXPECT_THAT(ReadWith("target_color: super-red", "target_color: reddish", &options).message(),
              testing::AllOf(HasSubstr("robot.yaml:"), HasSubstr("reddish")));
  EXPECT_THAT(ReadWith("pan_deg: [-60, 60]", "pan_deg: [60, -60]", &options).message(),
              HasSubstr("right below left"));
  EXPECT_THAT(ReadWith("seed: 1", "seed: -1", &options).message(), HasSubstr("negative"));
  EXPECT_THAT(ReadWith("wander_s: 7.0", "wonder_s: 7.0", &options).message(),
              HasSubstr("wonder_s"));
  EXPECT_THAT(ReadWith("min_stripes: 4", "min_stripes: 9", &options).message(),
              HasSubstr("min_stripes"));
}

}  // namespace
}  // namespace geon::planner
