#include "messaging/daemon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace geon::messaging {
namespace {

using ::testing::HasSubstr;

constexpr const char* kUrl = "udpm://239.255.76.67:7688?ttl=0";

TEST(RunDaemonTest, ExitCodeIsWhatTheDaemonReturnsOfItsLoop) {
  const int code = RunDaemon({{"geon-test", "1", "00"}, kUrl}, [](const Daemon& daemon) {
    int ticks = 0;
    daemon.loop->Every(0.001, [&] {
      if (++ticks == 3) daemon.loop->Stop();
    });
    daemon.loop->Run();
    return 40 + ticks;
  });
  EXPECT_EQ(code, 43);
}

TEST(RunDaemonTest, WhatIsThrownIsLoggedAndIsAFailure) {
  testing::internal::CaptureStderr();
  const int code = RunDaemon({{"geon-test", "1", "00"}, kUrl}, [](const Daemon&) -> int {
    throw std::runtime_error("the camera is gone");
  });
  EXPECT_EQ(code, 1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("the camera is gone"));
}

TEST(RunDaemonTest, ABusThatCannotBeOpenedIsNotReady) {
  testing::internal::CaptureStderr();
  const int code = RunDaemon({{"geon-test", "1", "00"}, "udpm://no.such.group"},
                             [](const Daemon&) { return 0; });
  EXPECT_EQ(code, 3);
  EXPECT_FALSE(testing::internal::GetCapturedStderr().empty());
}

}  // namespace
}  // namespace geon::messaging
