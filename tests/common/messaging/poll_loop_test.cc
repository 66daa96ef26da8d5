#include "messaging/poll_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include "base/contracts.h"

namespace geon::messaging {
namespace {

using testing::ElementsAre;

class Event {
 public:
  Event() : fd_(eventfd(0, EFD_NONBLOCK)) {}
  ~Event() { close(fd_); }
  int fd() const { return fd_; }
  void Ring() const { EXPECT_EQ(eventfd_write(fd_, 1), 0); }
  void Quiet() const {
    eventfd_t value = 0;
    eventfd_read(fd_, &value);
  }

 private:
  int fd_;
};

TEST(PollLoop, CallsBackWhenADescriptorIsReadable) {
  PollLoop loop;
  Event event;
  int calls = 0;
  loop.Watch(event.fd(), [&] {
    event.Quiet();
    if (++calls == 3) {
      loop.Stop();
    } else {
      event.Ring();
    }
  });
  event.Ring();
  loop.Run();
  EXPECT_EQ(calls, 3);
  EXPECT_GE(loop.rounds(), 3);
}

TEST(PollLoop, AWatchMayRemoveItselfAndOthers) {
  PollLoop loop;
  Event first;
  Event second;
  int calls = 0;
  const auto remove_both = [&] {
    ++calls;
    loop.Unwatch(first.fd());
    loop.Unwatch(second.fd());
    loop.Every(1e-4, [&] { loop.Stop(); });
  };
  loop.Watch(first.fd(), remove_both);
  loop.Watch(second.fd(), remove_both);
  first.Ring();
  second.Ring();
  loop.Run();
  EXPECT_EQ(calls, 1);
}

TEST(PollLoop, TicksAtOnceAndThenPeriodically) {
  PollLoop loop;
  int ticks = 0;
  loop.Every(1e-3, [&] {
    if (++ticks == 5) loop.Stop();
  });
  loop.Run();
  EXPECT_EQ(ticks, 5);
}

TEST(PollLoop, EndsOnASignalAndRunsTheStopCallbacksLastFirst) {
  PollLoop loop;
  std::vector<std::string> calls;
  loop.OnStop([&] { calls.emplace_back("first"); });
  loop.OnStop([&] { calls.emplace_back("second"); });
  loop.Every(10.0, [] { kill(getpid(), SIGTERM); });
  loop.Run();
  EXPECT_THAT(calls, ElementsAre("second", "first"));
}

TEST(PollLoop, HangUpOfTheTerminalEndsItToo) {
  PollLoop loop;
  bool stopped = false;
  loop.OnStop([&] { stopped = true; });
  loop.Every(10.0, [] { kill(getpid(), SIGHUP); });
  loop.Run();
  EXPECT_TRUE(stopped);
}

TEST(PollLoop, WhatACallbackThrowsLeavesAfterTheStopCallbacks) {
  PollLoop loop;
  bool stopped = false;
  loop.OnStop([&] { stopped = true; });
  loop.Every(1.0, [] { throw std::runtime_error("broken"); });
  EXPECT_THROW(loop.Run(), std::runtime_error);
  EXPECT_TRUE(stopped);
}

TEST(PollLoop, RefusesNonsense) {
  PollLoop loop;
  EXPECT_THROW(loop.Every(0.0, [] {}), ContractViolation);
  EXPECT_THROW(loop.Watch(-1, [] {}), ContractViolation);
}

}  // namespace
}  // namespace geon::messaging
