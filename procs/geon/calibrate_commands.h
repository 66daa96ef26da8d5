#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace geon::cli {

// `geon calibrate ...`, one subcommand each.
void AddCalibrateLutCommand(CLI::App* calibrate, int* exit_code);
void AddCalibrateRigCommand(CLI::App* calibrate, int* exit_code);
void AddCalibrateCompareCommand(CLI::App* calibrate, int* exit_code);

// YYYY-MM-DD, in UTC.
std::string Today();

}  // namespace geon::cli
