#include "device/serial_link.h"

#include <gtest/gtest.h>

#include <string>

#include "base/contracts.h"
#include "tests/common/device/plug.h"

namespace geon::device {
namespace {

TEST(SerialLinkTest, FollowsADeviceThroughUnplugAndReplug) {
  Plug plug;
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_FALSE(link.Service(0.0).opened);
  EXPECT_NE(link.trouble().find("cannot open"), std::string::npos);
  plug.In();
  EXPECT_FALSE(link.Service(0.1).opened) << "the first retry waits";
  EXPECT_TRUE(link.Service(0.25).opened);
  EXPECT_EQ(link.reconnects(), 0);
  link.Send("hello");
  EXPECT_EQ(plug.Hear(), "hello");
  plug.Say("there");
  EXPECT_EQ(link.Service(0.3).bytes, "there");
  plug.Out();
  EXPECT_TRUE(link.Service(0.4).lost);
  EXPECT_FALSE(link.is_open());
  EXPECT_FALSE(link.trouble().empty());
  link.Send("into the void");
  plug.In();
  EXPECT_TRUE(link.Service(10.0).opened);
  EXPECT_EQ(link.reconnects(), 1);
  EXPECT_EQ(plug.Hear(), "") << "what was said meanwhile is gone";
}

TEST(SerialLinkTest, ALossSeenWhileSendingIsReportedOnce) {
  Plug plug;
  plug.In();
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_TRUE(link.Service(0.0).opened);
  plug.Out();
  link.Send("x");
  EXPECT_FALSE(link.is_open());
  EXPECT_TRUE(link.Service(0.1).lost);
  EXPECT_FALSE(link.Service(0.2).lost);
}

TEST(SerialLinkTest, WaitsLongerBetweenAttemptsUpToALimit) {
  Plug plug;
  SerialLink link({.path = plug.path(), .first_retry_s = 0.1, .longest_retry_s = 0.4});
  const auto service_until = [&](int from_ms, int to_ms) {
    for (int t_ms = from_ms; t_ms < to_ms; t_ms += 10) {
      if (link.Service(t_ms * 1e-3).opened) return t_ms;
    }
    return -1;
  };
  EXPECT_EQ(service_until(0, 1530), -1);  // tries at 0, 0.1, 0.3, 0.7, 1.1, 1.5 s
  plug.In();
  EXPECT_NEAR(service_until(1530, 5000), 1900, 40);
  EXPECT_THROW(SerialLink({.path = ""}), ContractViolation);
}

TEST(SerialLinkTest, ADeviceThatTakesNoBytesIsGivenUp) {
  Plug plug;
  plug.In();
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_TRUE(link.Service(0.0).opened);
  for (int i = 0; i < 2000 && link.is_open(); ++i) link.Send(std::string(100, 'x'));
  EXPECT_FALSE(link.is_open());
  EXPECT_TRUE(link.Service(0.1).lost);
}

}  // namespace
}  // namespace geon::device
