#include "config/bus_config.h"

#include <gtest/gtest.h>

namespace geon::config {
namespace {

Status ReadFrom(const std::string& text, const std::string& lcm_url, std::string* url) {
  DaemonArguments arguments("geon-test", "Tests.", "geon-test");
  arguments.lcm_url = lcm_url;
  Result<YamlDocument> document = YamlDocument::Parse(text, "robot.yaml");
  if (!document.ok()) return document.status();
  *url = ReadBusUrl(arguments, document->root().Child("bus"));
  return document->Finish();
}

TEST(BusConfigTest, TheCommandLineWinsOverTheFile) {
  std::string url;
  const std::string text = "bus: {url: \"udpm://239.255.76.67:7667?ttl=0\"}";
  EXPECT_TRUE(ReadFrom(text, "", &url).ok());
  EXPECT_EQ(url, "udpm://239.255.76.67:7667?ttl=0");
  EXPECT_TRUE(ReadFrom(text, "memq://", &url).ok());
  EXPECT_EQ(url, "memq://");
}

TEST(BusConfigTest, TheFileIsCheckedEvenWhenItDoesNotWin) {
  std::string url;
  const Status status = ReadFrom("bus: {url: somewhere}", "memq://", &url);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.message().find("robot.yaml:1"), std::string::npos);
  EXPECT_NE(status.message().find("must be an LCM URL"), std::string::npos);
}

}  // namespace
}  // namespace geon::config
