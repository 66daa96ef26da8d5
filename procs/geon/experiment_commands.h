#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "procs/geon/bench_record.h"
#include "procs/geon/experiment_color_record.h"
#include "procs/geon/experiment_record.h"
#include "procs/geon/experiment_shapes.h"
#include "procs/geon/navigation_record.h"
#include "procs/geon/robot_record.h"

namespace geon::cli {

// The subcommands of `geon experiment`, each in experiment_<name>_command.cc.
void AddExperimentShapesCommand(CLI::App& experiment, int* exit_code);
void AddExperimentBenchCommand(CLI::App& experiment, int* exit_code);
void AddExperimentColorCommand(CLI::App& experiment, int* exit_code);
void AddExperimentBackgroundCommand(CLI::App& experiment, int* exit_code);
void AddExperimentNavigationCommand(CLI::App& experiment, int* exit_code);
void AddExperimentRobotCommand(CLI::App& experiment, int* exit_code);
void AddExperimentMergeCommand(CLI::App& experiment, int* exit_code);
void AddExperimentTuneCommand(CLI::App& experiment, int* exit_code);

// Two numbers with a sign between them, as in 30:70 and 2/8.
bool ReadNumberPair(const std::string& text, char sign, int* first, int* second);

// --shard i/n and --jobs.
void AddSpreadArguments(CLI::App& command, std::string* shard, int* jobs);
Shard ParseShard(const std::string& text);  // as AddSpreadArguments checked it

// A record as text: results.json, the tables and the page.
struct RecordTexts {
  std::string json, tables, page;
};
// Prints the tables (or the JSON) of a record and writes results.json, timing.json and report.html
// where `output` is not empty. Returns the exit code.
int DeliverText(const RecordTexts& texts, double seconds, bool json,
                const std::filesystem::path& output);
int Deliver(const ShapeRecord& record, double seconds, bool json,
            const std::filesystem::path& output);
int Deliver(const BenchRecord& record, double seconds, bool json,
            const std::filesystem::path& output);
int Deliver(const ColorRecord& record, double seconds, bool json,
            const std::filesystem::path& output);
int Deliver(const NavigationRecord& record, double seconds, bool json,
            const std::filesystem::path& output);
int Deliver(const RobotRecord& record, double seconds, bool json,
            const std::filesystem::path& output);

}  // namespace geon::cli
