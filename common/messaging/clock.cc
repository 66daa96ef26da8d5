#include "messaging/clock.h"

#include <ctime>

namespace geon::messaging {
namespace {

timespec Now(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return now;
}

}  // namespace

int64_t Utime() {
  const timespec now = Now(CLOCK_REALTIME);
  return static_cast<int64_t>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
}

double MonotonicSeconds() {
  const timespec now = Now(CLOCK_MONOTONIC);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace geon::messaging
