#include "messaging/bus_statistics.h"

#include <gtest/gtest.h>

#include "messaging/channels.h"
#include "messaging/rate_limiter.h"

namespace geon::messaging {
namespace {

TEST(BusStatistics, CountsHolesInSeqAsLosses) {
  BusStatistics statistics;
  EXPECT_EQ(statistics.CountReceived("A", 5, 100), 0);  // joined late
  EXPECT_EQ(statistics.CountReceived("A", 6, 100), 0);
  EXPECT_EQ(statistics.CountReceived("A", 9, 100), 2);
  EXPECT_EQ(statistics.CountReceived("B", 1, 50), 0);
  EXPECT_EQ(statistics.lost(), 2);
  EXPECT_EQ(statistics.received(), 4);
  EXPECT_EQ(statistics.channels().find("A")->second.bytes, 300);
}

TEST(BusStatistics, APublisherThatStartsAnewIsNoLoss) {
  BusStatistics statistics;
  statistics.CountReceived("A", 500, 1);
  EXPECT_EQ(statistics.CountReceived("A", 1, 1), 0);
  EXPECT_EQ(statistics.CountReceived("A", 3, 1), 1);
  EXPECT_EQ(statistics.CountReceived("A", 2'000'000'000, 1), 0);
}

TEST(BusStatistics, TheSharedChannelIsNotJudged) {
  BusStatistics statistics;
  statistics.CountReceived(kGeonSession, 1, 1);
  EXPECT_EQ(statistics.CountReceived(kGeonSession, 9, 1), 0);
}

TEST(BusStatistics, CountsWhatWasRefused) {
  BusStatistics statistics;
  statistics.CountRefused("A");
  statistics.CountRefused("A");
  EXPECT_EQ(statistics.refused(), 2);
  EXPECT_EQ(statistics.received(), 0);
}

TEST(RateLimiter, LetsOneThroughPerPeriodAndCountsTheOthers) {
  RateLimiter limiter(5.0);
  EXPECT_EQ(limiter.Pass(10.0), 1);
  EXPECT_EQ(limiter.Pass(11.0), std::nullopt);
  EXPECT_EQ(limiter.Pass(14.9), std::nullopt);
  EXPECT_EQ(limiter.Pass(15.0), 3);
  EXPECT_EQ(limiter.Pass(20.0), 1);
}

}  // namespace
}  // namespace geon::messaging
