#include "messaging/clock.h"

#include <gtest/gtest.h>

#include <ctime>

namespace geon::messaging {
namespace {

TEST(Clock, UtimeIsMicrosecondsSinceTheEpoch) {
  EXPECT_NEAR(static_cast<double>(Utime()) * 1e-6, static_cast<double>(std::time(nullptr)), 2.0);
}

TEST(Clock, MonotonicTimeDoesNotRunBackwards) {
  const double before_s = MonotonicSeconds();
  EXPECT_GE(MonotonicSeconds(), before_s);
}

}  // namespace
}  // namespace geon::messaging
