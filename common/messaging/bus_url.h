#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace geon::messaging {

// Smallest receive buffer with which 900 KB images arrive whole (measured: docs/channels.md).
inline constexpr int64_t kNeededReceiveBuffer = 1'000'000;
inline constexpr int64_t kDefaultReceiveBuffer = 4'194'304;

// The URL with recv_buf_size=kDefaultReceiveBuffer appended when it is udpm and does not say. A URL
// that says recv_buf_size=0 asks for the kernel's default buffer and keeps it.
std::string WithReceiveBuffer(const std::string& url);

// What the kernel will grant: net.core.rmem_max and rmem_default.
struct KernelBufferLimits {
  int64_t max_bytes = 0;
  int64_t default_bytes = 0;
};
std::optional<KernelBufferLimits> ReadKernelBufferLimits(
    const std::filesystem::path& directory = "/proc/sys/net/core");

// The buffer that a udpm URL really gets; nothing for other providers (memq, file), which need
// none.
std::optional<int64_t> GrantedReceiveBuffer(const std::string& url,
                                            const KernelBufferLimits& limits);

// A warning with the cure when the granted buffer is too small for images, or smaller than asked
// for.
std::optional<std::string> ReceiveBufferWarning(const std::string& url,
                                                const KernelBufferLimits& limits);

}  // namespace geon::messaging
