#pragma once

#include <CLI/CLI.hpp>

namespace geon::cli {

// Exit codes of every `geon` command (contract).
enum ExitCode { kOk = 0, kFailed = 1, kUsage = 2, kNotReady = 3 };

// Each function adds one subcommand, in <name>_command.cc. Its callback stores the exit code in
// *exit_code. Results go to stdout, talk to stderr.
void AddUpCommand(CLI::App& app, int* exit_code);
void AddDownCommand(CLI::App& app, int* exit_code);
void AddStatusCommand(CLI::App& app, int* exit_code);
void AddDoctorCommand(CLI::App& app, int* exit_code);
void AddWatchCommand(CLI::App& app, int* exit_code);
void AddSegmentCommand(CLI::App& app, int* exit_code);
void AddTeachCommand(CLI::App& app, int* exit_code);
void AddStripeCommand(CLI::App& app, int* exit_code);
void AddCalibrateCommand(CLI::App& app, int* exit_code);
void AddRecognizeCommand(CLI::App& app, int* exit_code);
void AddLogCommand(CLI::App& app, int* exit_code);
void AddReplayCommand(CLI::App& app, int* exit_code);
void AddReportCommand(CLI::App& app, int* exit_code);
void AddWorldCommand(CLI::App& app, int* exit_code);
void AddScanCommand(CLI::App& app, int* exit_code);
void AddTrainCommand(CLI::App& app, int* exit_code);
void AddExperimentCommand(CLI::App& app, int* exit_code);

}  // namespace geon::cli
