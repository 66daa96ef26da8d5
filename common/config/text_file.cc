#include "config/text_file.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

namespace geon::config {

Result<std::string> ReadFile(const std::filesystem::path& file, size_t max_bytes) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    return Status::Error(file.string() + ": is a directory, a file is needed");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return Status::Error(file.string() + ": cannot open: " + std::strerror(errno));
  }
  std::string bytes;
  std::array<char, 1U << 16U> chunk;
  while (stream && bytes.size() <= max_bytes) {
    stream.read(chunk.data(), chunk.size());
    bytes.append(chunk.data(), static_cast<size_t>(stream.gcount()));
  }
  if (stream.bad()) return Status::Error(file.string() + ": cannot read: " + std::strerror(errno));
  if (bytes.size() > max_bytes) {
    return Status::Error(file.string() + ": larger than the " + std::to_string(max_bytes) +
                         " bytes such a file may have");
  }
  return bytes;
}

Status WriteFileAtomically(const std::filesystem::path& file, const std::string& bytes) {
  const std::filesystem::path temporary =
      file.string() + "." + std::to_string(::getpid()) + ".part";
  {
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) {
      const std::string why = std::strerror(errno);
      std::error_code ignored;
      std::filesystem::remove(temporary, ignored);
      return Status::Error(file.string() + ": cannot write: " + why);
    }
  }
  std::error_code error;
  std::filesystem::rename(temporary, file, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return Status::Error(file.string() + ": cannot replace: " + error.message());
  }
  return Status::Ok();
}

std::string ContentHash(std::string_view bytes) {
  uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<uint8_t>(byte)) * 0x100000001b3ULL;
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace geon::config
