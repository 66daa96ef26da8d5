#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/status.h"

namespace geon::config {

// The bytes of a file, at most max_bytes (more is an error, not a truncation).
Result<std::string> ReadFile(const std::filesystem::path& file, size_t max_bytes = 64U << 20U);

// Writes the whole file or leaves the old one: through a temporary file beside it, then rename.
Status WriteFileAtomically(const std::filesystem::path& file, const std::string& bytes);

// FNV-1a of bytes, 16 hex digits: tells whether a file was changed, not by whom.
std::string ContentHash(std::string_view bytes);

}  // namespace geon::config
