#include "messaging/poll_loop.h"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/contracts.h"
#include "messaging/clock.h"

namespace geon::messaging {
namespace {

constexpr int kLongestWaitMs = 1000;

std::runtime_error SystemError(const std::string& what) {
  return std::runtime_error(what + ": " + std::strerror(errno));
}

int OpenSignalFd() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGHUP);
  if (pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) throw SystemError("blocking signals");
  const int fd = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
  if (fd < 0) throw SystemError("signalfd");
  return fd;
}

}  // namespace

PollLoop::PollLoop() : signal_fd_(OpenSignalFd()) {
  Watch(signal_fd_, [this] {
    signalfd_siginfo info{};
    if (read(signal_fd_, &info, sizeof(info)) != sizeof(info)) return;
    spdlog::info("ending on signal {}", strsignal(static_cast<int>(info.ssi_signo)));
    Stop();
  });
}

PollLoop::~PollLoop() { close(signal_fd_); }

void PollLoop::Watch(int fd, std::function<void()> readable) {
  Require(fd >= 0, "PollLoop::Watch: fd must not be negative");
  watches_[fd] = std::move(readable);
}

void PollLoop::Unwatch(int fd) { watches_.erase(fd); }

void PollLoop::Every(double period_s, std::function<void()> tick) {
  Require(period_s > 0.0, "PollLoop::Every: the period must be positive");
  timers_.push_back({period_s, MonotonicSeconds(), std::move(tick)});
}

void PollLoop::OnStop(std::function<void()> stop) { stop_callbacks_.push_back(std::move(stop)); }

void PollLoop::Run() {
  stopping_ = false;
  try {
    while (!stopping_) Round();
  } catch (...) {
    RunStopCallbacks();
    throw;
  }
  RunStopCallbacks();
}

void PollLoop::Round() {
  std::vector<pollfd> fds;
  fds.reserve(watches_.size());
  for (const auto& [fd, readable] : watches_) fds.push_back({fd, POLLIN, 0});
  if (poll(fds.data(), fds.size(), MillisecondsToNextTimer()) < 0 && errno != EINTR) {
    throw SystemError("poll");
  }
  ++rounds_;
  for (const pollfd& ready : fds) {
    if (ready.revents == 0 || stopping_) continue;
    const auto watch = watches_.find(ready.fd);  // an earlier callback may have removed it
    if (watch == watches_.end()) continue;
    const std::function<void()> readable = watch->second;  // it may remove itself
    readable();
  }
  RunTimers();
}

void PollLoop::RunTimers() {
  for (size_t i = 0; i < timers_.size() && !stopping_; ++i) {
    const double now_s = MonotonicSeconds();
    if (now_s < timers_[i].next_s) continue;
    const double period_s = timers_[i].period_s;
    const double behind_s = now_s - timers_[i].next_s;
    timers_[i].next_s += period_s * (std::floor(behind_s / period_s) + 1.0);
    const std::function<void()> tick = timers_[i].tick;  // it may add timers
    tick();
  }
}

int PollLoop::MillisecondsToNextTimer() const {
  double wait_s = kLongestWaitMs * 1e-3;
  const double now_s = MonotonicSeconds();
  for (const Timer& timer : timers_) wait_s = std::min(wait_s, timer.next_s - now_s);
  return wait_s <= 0.0 ? 0 : static_cast<int>(std::ceil(wait_s * 1e3));
}

void PollLoop::RunStopCallbacks() {
  while (!stop_callbacks_.empty()) {
    const std::function<void()> stop = std::move(stop_callbacks_.back());
    stop_callbacks_.pop_back();
    stop();
  }
}

}  // namespace geon::messaging
