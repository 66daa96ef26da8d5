#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "config/scan_set_json.h"
#include "config/verdict_json.h"
#include "procs/geon/commands.h"
#include "procs/geon/recognition_arguments.h"
#include "procs/geon/verdict_text.h"
#include "recognition/recognize_geon.h"

namespace geon::cli {
namespace {

struct RecognizeArguments {
  std::vector<std::string> files;
  RecognitionArguments recognition;
  bool json = false;
};

// One file; false when it cannot be read.
bool Recognize(const std::string& file, const recognition::RecognitionOptions& options,
               bool as_json) {
  const Result<sensor::ScanSet> scan = config::LoadScanSet(file);
  if (!scan.ok()) {
    std::cerr << "geon recognize: " << scan.message() << "\n";
    return false;
  }
  const auto begin = std::chrono::steady_clock::now();
  const sensor::GeonVerdict verdict = recognition::RecognizeGeon(*scan, options);
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(
                                std::chrono::steady_clock::now() - begin)
                                .count();
  if (as_json) {
    std::cout << config::SerializeVerdict(verdict, file, microseconds) << std::endl;
  } else {
    std::cout << file << ": " << VerdictText(verdict);
  }
  return true;
}

}  // namespace

void AddRecognizeCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<RecognizeArguments>();
  CLI::App* command = app.add_subcommand("recognize", "Names the geons that scan sets show.");
  command->add_option("FILE", arguments->files, "scan sets (geon.scan_set.v1)")->required();
  AddRecognitionArguments(*command, &arguments->recognition);
  command->add_flag("--json", arguments->json, "one JSON object a line (geon.verdict.v1)");
  command->footer("Exit 1 if any file could not be read; the others are recognised all the same.");
  command->callback([arguments, exit_code] {
    const recognition::RecognitionOptions options = ToOptions(arguments->recognition);
    for (const std::string& file : arguments->files) {
      if (!Recognize(file, options, arguments->json)) *exit_code = kFailed;
    }
  });
}

}  // namespace geon::cli
