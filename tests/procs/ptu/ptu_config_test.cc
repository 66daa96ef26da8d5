#include "procs/ptu/ptu_config.h"

#include <gtest/gtest.h>

#include <string>

#include "base/angles.h"

namespace geon::ptu {
namespace {

Status Read(const std::string& text, PtuConfig* config) {
  Result<config::YamlDocument> document = config::YamlDocument::Parse(text, "robot.yaml");
  if (!document.ok()) return document.status();
  ReadPtuSection(document->root(), config);
  return document->Finish();
}

TEST(PtuConfigTest, ReadsTheInstalledRobotFile) {
  const config::DaemonArguments arguments("geon-ptu", "test", "test");
  const Result<PtuConfig> config = LoadPtuConfig(arguments, "");
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->link.baud, 9600);
  EXPECT_NEAR(config->driver.speed_rad_s, RadiansFromDegrees(51.4), 1e-9);
  const Result<PtuConfig> elsewhere = LoadPtuConfig(arguments, "run/ptu.tty");
  ASSERT_TRUE(elsewhere.ok());
  EXPECT_EQ(elsewhere->link.path, "run/ptu.tty");
}

TEST(PtuConfigTest, RefusesWhatMakesNoSenseWithItsLine) {
  PtuConfig config;
  const Status status = Read(
      "port: \"\"\nbaud: 110\nspeed_deg_s: 400\nreset_at_start: maybe\ncolour: red\n", &config);
  ASSERT_FALSE(status.ok());
  for (const std::string part :
       {"robot.yaml:1: 'port'", "robot.yaml:2: 'baud'", "robot.yaml:3: 'speed_deg_s'",
        "robot.yaml:4: 'reset_at_start'", "robot.yaml:5: 'colour'"}) {
    EXPECT_NE(status.message().find(part), std::string::npos) << part << "\n" << status.message();
  }
}

}  // namespace
}  // namespace geon::ptu
