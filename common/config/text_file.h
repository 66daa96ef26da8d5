#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"

namespace geon::config {

// The bytes of a file, at most max_bytes (more is an error, not a truncation).
Result<std::string> ReadFile(const std::filesystem::path& file, size_t max_bytes = 64U << 20U);

// Writes the whole file or leaves the old one: through a temporary file beside it, then rename.
Status WriteFileAtomically(const std::filesystem::path& file, const std::string& bytes);

}  // namespace geon::config
