#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>

#include "config/text_file.h"
#include "evaluation/train_forest.h"
#include "procs/geon/commands.h"
#include "procs/geon/train_views_command.h"
#include "procs/geon/training_jobs.h"

namespace geon::cli {
namespace {

struct TrainArguments {
  evaluation::TrainingOptions training;
  int jobs = 1;
  std::filesystem::path output;
};

int Train(const TrainArguments& arguments) {
  evaluation::TrainingReport report;
  TrainingJobs jobs("geon train", arguments.jobs);
  const evaluation::OwnedForest forest =
      evaluation::TrainForest(arguments.training, jobs.ForEach(), &report);
  const Status written = config::WriteFileAtomically(
      arguments.output, evaluation::ForestSource(forest, arguments.training));
  if (!written.ok()) {
    std::cerr << "geon train: " << written.message() << '\n';
    return kFailed;
  }
  std::cout << std::fixed << std::setprecision(1) << forest.roots.size() << " trees, "
            << forest.nodes.size() << " nodes, " << forest.features << " measurements\n"
            << "on " << report.calibration_scans
            << " scans that no tree has seen: " << 100.0 * report.right_1 << " % right; "
            << 100.0 * report.decided_1 << " % decided, of which " << std::setprecision(2)
            << 100.0 * report.decided_right_1 << " % right\n";
  return kOk;
}

}  // namespace

void AddTrainCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<TrainArguments>();
  evaluation::TrainingOptions& training = arguments->training;
  CLI::App* command = app.add_subcommand(
      "train", "Trains the forest of method evidence on scans of random shapes.");
  command->add_option("--seed", training.seed, "of shapes, scans and trees")->capture_default_str();
  command->add_option("--scans", training.scans, "to grow the trees on")
      ->check(CLI::Range(100, 10000000))
      ->capture_default_str();
  command->add_option("--calibration-scans", training.calibration_scans, "to fit the posterior on")
      ->check(CLI::Range(100, 10000000))
      ->capture_default_str();
  command->add_option("--trees", training.trees, "that vote")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--depth", training.depth, "of the deepest tree")
      ->check(CLI::Range(1, 25))
      ->capture_default_str();
  command
      ->add_option("--jobs", arguments->jobs, "scans made and groups of ten trees grown at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  CLI::Option* output =
      command->add_option("-o,--output", arguments->output, "C++ source of the forest")->required();
  command->footer(
      "Same options, same bytes, whatever the number of jobs. To use it: geon train --jobs 2 -o "
      "common/recognition/trained_forest.inc, "
      "then build again.");
  CLI::App* views = AddTrainViewsCommand(*command, exit_code);
  // The forest's options are not those of `views`.
  views->preparse_callback([output](size_t) { output->required(false); });
  for (CLI::Option* option : command->get_options()) {
    if (option != command->get_help_ptr()) views->excludes(option);
  }
  command->callback([arguments, command, exit_code] {
    if (command->get_subcommands().empty()) *exit_code = Train(*arguments);
  });
}

}  // namespace geon::cli
