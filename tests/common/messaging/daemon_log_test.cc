#include "messaging/daemon_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

namespace geon::messaging {
namespace {

TEST(DaemonLog, WritesOneLineWithTimeLevelAndProcess) {
  StartLog("geon-test");
  testing::internal::CaptureStderr();
  spdlog::warn("something happened where={}", "here");
  const std::string line = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(
      testing::Matcher<std::string>(
          testing::MatchesRegex(
              "....-..-..T..:..:......  *warning geon-test: something happened where=here\n"))
          .Matches(line))
      << line;
}

}  // namespace
}  // namespace geon::messaging
