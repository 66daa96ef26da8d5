#pragma once

#include <string>

namespace geon::messaging {

// Sets up spdlog's default logger for a daemon: stderr, one line each,
// `2026-01-31T12:00:00.123 warning geon-ptu: sentence key=value`. Call it first in main().
void StartLog(const std::string& process);

}  // namespace geon::messaging
