#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/status.h"

namespace geon::cli {

using Environment = std::map<std::string, std::string>;

struct ProgramOutcome {
  int exit_code = 0;   // 128 + n when signal n ended it
  std::string output;  // stdout and stderr
};

// Runs a program (looked up in PATH) to its end, with `additions` on top of our environment.
Result<ProgramOutcome> RunProgram(const std::vector<std::string>& words,
                                  const Environment& additions);

}  // namespace geon::cli
