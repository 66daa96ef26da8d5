#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"

namespace geon::cli {
namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> shards;
  std::filesystem::path output;
  bool json = false;
};

int FailMerge(const std::string& message) {
  std::cerr << "geon experiment merge: " << message << '\n';
  return kFailed;
}

// What the file says it is, to know how to read it.
Result<nlohmann::json> LoadResults(const std::filesystem::path& file) {
  const Result<std::string> text = config::ReadFile(file, size_t{1} << 30U);
  if (!text.ok()) return text.status();
  nlohmann::json value = nlohmann::json::parse(*text, nullptr, false);
  if (!value.is_object()) return Status::Error(file.string() + ": damaged results: no JSON object");
  return value;
}

// `Record` is one of the experiments', with its ways to parse and to merge.
template <typename Record>
int MergeAs(const std::vector<nlohmann::json>& values, const MergeArguments& arguments,
            Result<Record> (*parse)(const nlohmann::json&, const std::string&),
            Result<Record> (*merge)(const std::vector<Record>&)) {
  std::vector<Record> shards;
  for (size_t k = 0; k < values.size(); ++k) {
    Result<Record> shard = parse(values[k], (arguments.shards[k] / "results.json").string());
    if (!shard.ok()) return FailMerge(shard.message());
    shards.push_back(std::move(*shard));
  }
  const Result<Record> all = merge(shards);
  if (!all.ok()) return FailMerge(all.message());
  return Deliver(*all, 0.0, arguments.json, arguments.output);
}

int Merge(const MergeArguments& arguments) {
  std::vector<nlohmann::json> values;
  for (const std::filesystem::path& directory : arguments.shards) {
    Result<nlohmann::json> value = LoadResults(directory / "results.json");
    if (!value.ok()) return FailMerge(value.message());
    values.push_back(std::move(*value));
  }
  if (values.front().value("experiment", "") == kBenchExperiment) {
    return MergeAs<BenchRecord>(values, arguments, ParseBenchRecord, MergeBenchRecords);
  }
  if (values.front().value("experiment", "") == kColorExperiment) {
    return MergeAs<ColorRecord>(values, arguments, ParseColorRecord, MergeColorRecords);
  }
  if (values.front().value("experiment", "") == kNavigationExperiment) {
    return MergeAs<NavigationRecord>(values, arguments, ParseNavigationRecord,
                                     MergeNavigationRecords);
  }
  if (values.front().value("experiment", "") == kRobotExperiment) {
    return MergeAs<RobotRecord>(values, arguments, ParseRobotRecord, MergeRobotRecords);
  }
  return MergeAs<ShapeRecord>(values, arguments, ParseRecord, MergeRecords);
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
