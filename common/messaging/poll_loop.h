#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace geon::messaging {

// The heart of a daemon: one thread, poll(2), timers by the monotonic clock, and a clean end on
// SIGTERM, SIGINT or SIGHUP. Construct it first in main(), before any thread starts: it blocks
// these signals, and threads inherit that. What a callback throws leaves Run() after the stop
// callbacks have run, so that devices are made safe on every way out.
//
// Callbacks may add and remove watches and timers and call Stop().
class PollLoop {
 public:
  PollLoop();
  ~PollLoop();
  PollLoop(const PollLoop&) = delete;
  PollLoop& operator=(const PollLoop&) = delete;

  // Calls `readable` whenever fd can be read or has failed (hang-up: read it to learn more).
  void Watch(int fd, std::function<void()> readable);
  void Unwatch(int fd);
  // First at once, then every period; periods missed while busy are skipped, not caught up.
  void Every(double period_s, std::function<void()> tick);
  // Called once when the loop ends, last added first.
  void OnStop(std::function<void()> stop);

  void Run();
  void Stop() { stopping_ = true; }

  // Rounds so far, for loop_hz in health.
  int64_t rounds() const { return rounds_; }

 private:
  struct Timer {
    double period_s;
    double next_s;
    std::function<void()> tick;
  };
  void Round();
  void RunTimers();
  int MillisecondsToNextTimer() const;
  void RunStopCallbacks();

  int signal_fd_ = -1;
  bool stopping_ = false;
  int64_t rounds_ = 0;
  std::map<int, std::function<void()>> watches_;
  std::vector<Timer> timers_;
  std::vector<std::function<void()>> stop_callbacks_;
};

}  // namespace geon::messaging
