#include <iostream>
#include <memory>

#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"

namespace geon::cli {
namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> shards;
  std::filesystem::path output;
  bool json = false;
};

int Merge(const MergeArguments& arguments) {
  std::vector<ShapeRecord> shards;
  for (const std::filesystem::path& directory : arguments.shards) {
    Result<ShapeRecord> shard = LoadRecord(directory / "results.json");
    if (!shard.ok()) {
      std::cerr << "geon experiment merge: " << shard.message() << '\n';
      return kFailed;
    }
    shards.push_back(std::move(*shard));
  }
  const Result<ShapeRecord> all = MergeRecords(shards);
  if (!all.ok()) {
    std::cerr << "geon experiment merge: " << all.message() << '\n';
    return kFailed;
  }
  return Deliver(*all, 0.0, arguments.json, arguments.output);
}

}  // namespace

void AddExperimentMergeCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command =
      experiment.add_subcommand("merge", "Joins the shards of one experiment, in any order.");
  command->add_option("DIR", arguments->shards, "folders that hold a results.json")
      ->required()
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("-o,--output", arguments->output,
                   "folder for the joint results.json and report.html")
      ->required();
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->callback([arguments, exit_code] { *exit_code = Merge(*arguments); });
}

}  // namespace geon::cli
