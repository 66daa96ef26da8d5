#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "recognition/recognition_options.h"

namespace geon::cli {

// How to recognise, as said on the command line: --method, --curvature, --smoothing, --background.
// Empty: not said.
struct RecognitionArguments {
  std::string method;
  std::string curvature;
  std::string smoothing;
  std::string background;
  bool any() const {
    return !method.empty() || !curvature.empty() || !smoothing.empty() || !background.empty();
  }
};

void AddRecognitionArguments(CLI::App& command, RecognitionArguments* arguments);

// What was said, on top of `base`.
recognition::RecognitionOptions ToOptions(const RecognitionArguments& arguments,
                                          recognition::RecognitionOptions base = {});

}  // namespace geon::cli
