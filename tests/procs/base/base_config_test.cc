#include "procs/base/base_config.h"

#include <gtest/gtest.h>

#include <string>

namespace geon::base {
namespace {

constexpr const char* kGood =
    "port: run/base.tty\nbaud: 38400\nspeed_limit_m_s: 0.4\nturn_rate_limit_deg_s: 30\n"
    "acceleration_m_s2: 0.5\nturn_acceleration_deg_s2: 60\ndead_man_s: 2\nsonar_interval_s: 0.04\n"
    "sonar_order: [15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0]\nbumper_zero_deg: 9\n";

Status Read(const std::string& text, BaseConfig* config) {
  Result<config::YamlDocument> document = config::YamlDocument::Parse(text, "robot.yaml");
  if (!document.ok()) return document.status();
  ReadBaseSection(document->root(), config);
  return document->Finish();
}

std::string With(const std::string& key, const std::string& value) {
  std::string text = kGood;
  const size_t begin = text.find(key + ": ");
  const size_t end = text.find('\n', begin);
  return text.replace(begin, end - begin, key + ": " + value);
}

TEST(BaseConfigTest, ReadsTheInstalledRobotFile) {
  const config::DaemonArguments arguments("geon-base", "test", "test");
  const Result<BaseConfig> config = LoadBaseConfig(arguments, "run/base.tty");
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->link.path, "run/base.tty");
  EXPECT_EQ(config->link.baud, 38400);
  EXPECT_EQ(config->guard.speed_limit_m_s, 0.5);
  EXPECT_EQ(config->driver.sonar_rate, 15);
}

TEST(BaseConfigTest, LimitsHoldForGuardAndDriver) {
  BaseConfig config;
  const Status status = Read(kGood, &config);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(config.guard.speed_limit_m_s, 0.4);
  EXPECT_EQ(config.driver.speed_limit_m_s, 0.4);
  EXPECT_EQ(config.guard.turn_rate_limit_rad_s, config.driver.turn_rate_limit_rad_s);
  EXPECT_EQ(config.driver.sonar_rate, 10);
  EXPECT_EQ(config.driver.sonar_order.front(), 15);
  EXPECT_EQ(config.driver.dead_man_s, 2);
}

TEST(BaseConfigTest, NothingUnsafeIsAccepted) {
  const std::pair<const char*, const char*> cases[] = {
      {"speed_limit_m_s", "0.51"},
      {"speed_limit_m_s", "0"},
      {"turn_rate_limit_deg_s", "61"},
      {"acceleration_m_s2", "-1"},
      {"dead_man_s", "0"},
      {"dead_man_s", "60"},
      {"sonar_interval_s", "2"},
      {"baud", "1200"},
      {"port", "\"\""},
      {"sonar_order", "[0, 1, 2]"},
      {"turn_acceleration_deg_s2", "0"},
      {"sonar_order", "[0, 0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]"},
      {"sonar_order", "[0.5, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]"}};
  for (const auto& [key, value] : cases) {
    BaseConfig config;
    const Status status = Read(With(key, value), &config);
    EXPECT_FALSE(status.ok()) << key << ": " << value;
    EXPECT_NE(status.message().find(key), std::string::npos) << status.message();
  }
}

}  // namespace
}  // namespace geon::base
