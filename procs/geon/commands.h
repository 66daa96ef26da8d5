#pragma once

#include <CLI/CLI.hpp>

namespace geon::cli {

// Exit codes of every `geon` command (contract).
enum ExitCode { kOk = 0, kFailed = 1, kUsage = 2, kNotReady = 3 };

// Each function adds one subcommand, in <name>_command.cc. Its callback stores the exit code in *exit_code.
// Results go to stdout, talk to stderr.

}  // namespace geon::cli
