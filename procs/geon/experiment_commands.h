#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "procs/geon/experiment_record.h"

namespace geon::cli {

// The subcommands of `geon experiment`, each in experiment_<name>_command.cc.
void AddExperimentShapesCommand(CLI::App& experiment, int* exit_code);
void AddExperimentMergeCommand(CLI::App& experiment, int* exit_code);
void AddExperimentTuneCommand(CLI::App& experiment, int* exit_code);

// Prints the tables (or the JSON) of a record and writes results.json, timing.json and report.html
// where `output` is not empty. Returns the exit code.
int Deliver(const ShapeRecord& record, double seconds, bool json,
            const std::filesystem::path& output);

}  // namespace geon::cli
