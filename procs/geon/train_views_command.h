#pragma once

#include <CLI/CLI.hpp>

namespace geon::cli {

// Adds `geon train views` and returns it.
CLI::App* AddTrainViewsCommand(CLI::App& train, int* exit_code);

}  // namespace geon::cli
