#include <CLI/CLI.hpp>

#include "config/daemon_arguments.h"
#include "procs/geon/commands.h"

int main(int argc, char** argv) {
  CLI::App app{"geon: the front door of geonbot"};
  app.set_version_flag("--version", geon::config::BuildVersion());
  app.require_subcommand(1);
  app.footer(
      "Every command: geon COMMAND --help. Exit codes: 0 ok, 1 failed, 2 usage, 3 not ready.");
  int exit_code = geon::cli::kOk;
  geon::cli::AddSegmentCommand(app, &exit_code);
  geon::cli::AddTeachCommand(app, &exit_code);
  geon::cli::AddStripeCommand(app, &exit_code);
  geon::cli::AddCalibrateCommand(app, &exit_code);
  geon::cli::AddUpCommand(app, &exit_code);
  geon::cli::AddDownCommand(app, &exit_code);
  geon::cli::AddStatusCommand(app, &exit_code);
  geon::cli::AddDoctorCommand(app, &exit_code);
  geon::cli::AddWatchCommand(app, &exit_code);
  geon::cli::AddRecognizeCommand(app, &exit_code);
  geon::cli::AddLogCommand(app, &exit_code);
  geon::cli::AddReplayCommand(app, &exit_code);
  geon::cli::AddReportCommand(app, &exit_code);
  geon::cli::AddWorldCommand(app, &exit_code);
  geon::cli::AddScanCommand(app, &exit_code);
  geon::cli::AddTrainCommand(app, &exit_code);
  geon::cli::AddExperimentCommand(app, &exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? geon::cli::kOk : geon::cli::kUsage;
  }
  return exit_code;
}
