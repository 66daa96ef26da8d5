#pragma once

#include <unistd.h>

#include <iostream>
#include <string>

namespace geon::cli {

// A bar on stderr that grows on a terminal; elsewhere silence.
inline void ShowProgressBar(const std::string& name, int done, int all) {
  if (::isatty(STDERR_FILENO) == 0) return;
  constexpr int kWidth = 40;
  const int filled = done * kWidth / all;
  std::cerr << "\r" << name << " [" << std::string(static_cast<size_t>(filled), '#')
            << std::string(static_cast<size_t>(kWidth - filled), ' ') << "] " << done << "/" << all
            << (done == all ? "\n" : "") << std::flush;
}

}  // namespace geon::cli
