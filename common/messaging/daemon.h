#pragma once

#include <functional>
#include <string>

#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"

namespace geon::messaging {

struct DaemonOptions {
  HealthIdentity identity;  // process, version, hash of its configuration
  std::string bus_url;
};

// What a daemon is given to work with.
struct Daemon {
  Bus* bus;
  PollLoop* loop;
  HealthReporter* health;
};

// Starts the log, opens the bus, reports health, and runs `serve`, which builds the daemon's node
// and runs the loop; what it returns is the exit code. 1: something was thrown, 3: the bus cannot
// be opened; both are in the log.
int RunDaemon(const DaemonOptions& options, const std::function<int(const Daemon&)>& serve);

}  // namespace geon::messaging
