#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"

namespace geon::cli {

void AddExperimentCommand(CLI::App& app, int* exit_code) {
  CLI::App* command = app.add_subcommand(
      "experiment", "Measures, in simulation, what the thesis measured in chapter 6.");
  command->require_subcommand(1);
  AddExperimentShapesCommand(*command, exit_code);
  AddExperimentBenchCommand(*command, exit_code);
  AddExperimentColorCommand(*command, exit_code);
  AddExperimentBackgroundCommand(*command, exit_code);
  AddExperimentNavigationCommand(*command, exit_code);
  AddExperimentRobotCommand(*command, exit_code);
  AddExperimentMergeCommand(*command, exit_code);
  AddExperimentTuneCommand(*command, exit_code);
}

}  // namespace geon::cli
