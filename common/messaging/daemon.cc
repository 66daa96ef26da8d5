#include "messaging/daemon.h"

#include <spdlog/spdlog.h>

#include <exception>

#include "messaging/daemon_log.h"

namespace geon::messaging {
namespace {

constexpr int kExitFailed = 1;
constexpr int kExitNotReady = 3;

}  // namespace

int RunDaemon(const DaemonOptions& options, const std::function<int(const Daemon&)>& serve) {
  StartLog(options.identity.process);
  try {
    PollLoop loop;
    auto bus = Bus::Open({options.bus_url, options.identity.process});
    if (!bus.ok()) {
      spdlog::error("{}", bus.message());
      return kExitNotReady;
    }
    HealthReporter health(bus->get(), &loop, options.identity);
    return serve({bus->get(), &loop, &health});
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return kExitFailed;
  }
}

}  // namespace geon::messaging
