#include "messaging/bus_url.h"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace geon::messaging {
namespace {

constexpr std::string_view kOption = "recv_buf_size=";

bool IsMulticast(const std::string& url) { return url.rfind("udpm://", 0) == 0; }

// What the URL asks for; nothing when it does not say, or says what is not a number.
std::optional<int64_t> RequestedReceiveBuffer(const std::string& url) {
  const size_t at = url.find(kOption);
  if (at == std::string::npos) return std::nullopt;
  int64_t bytes = 0;
  const char* begin = url.data() + at + kOption.size();
  const auto [end, error] = std::from_chars(begin, url.data() + url.size(), bytes);
  if (error != std::errc() || end == begin) return std::nullopt;
  return bytes;
}

std::optional<int64_t> ReadNumber(const std::filesystem::path& file) {
  std::ifstream stream(file);
  int64_t number = 0;
  if (!(stream >> number)) return std::nullopt;
  return number;
}

}  // namespace

std::string WithReceiveBuffer(const std::string& url) {
  if (!IsMulticast(url) || url.find(kOption) != std::string::npos) return url;
  const char separator = url.find('?') == std::string::npos ? '?' : '&';
  return url + separator + std::string(kOption) + std::to_string(kDefaultReceiveBuffer);
}

std::optional<KernelBufferLimits> ReadKernelBufferLimits(const std::filesystem::path& directory) {
  const std::optional<int64_t> max = ReadNumber(directory / "rmem_max");
  const std::optional<int64_t> standard = ReadNumber(directory / "rmem_default");
  if (!max || !standard) return std::nullopt;
  return KernelBufferLimits{*max, *standard};
}

std::optional<int64_t> GrantedReceiveBuffer(const std::string& url,
                                            const KernelBufferLimits& limits) {
  if (!IsMulticast(url)) return std::nullopt;
  const int64_t requested = RequestedReceiveBuffer(url).value_or(0);
  return requested > 0 ? std::min(requested, limits.max_bytes) : limits.default_bytes;
}

std::optional<std::string> ReceiveBufferWarning(const std::string& url,
                                                const KernelBufferLimits& limits) {
  const std::optional<int64_t> granted = GrantedReceiveBuffer(url, limits);
  if (!granted) return std::nullopt;
  const int64_t requested = RequestedReceiveBuffer(url).value_or(0);
  const bool capped = requested > *granted;
  if (*granted >= kNeededReceiveBuffer && !capped) return std::nullopt;

  std::string text = "the LCM receive buffer is " + std::to_string(*granted) + " bytes";
  if (capped) {
    text += ", not the " + std::to_string(requested) +
            " asked for, because net.core.rmem_max caps it: raise the cap with `sudo sysctl -w "
            "net.core.rmem_max=" +
            std::to_string(std::max(requested, kDefaultReceiveBuffer)) +
            "` (for good: scripts/config/60-geon.conf to /etc/sysctl.d/)";
  } else {
    text +=
        " because the LCM URL says so: use recv_buf_size=" + std::to_string(kDefaultReceiveBuffer) +
        " in it, or leave the option out";
  }
  if (*granted < kNeededReceiveBuffer) text += ". IMAGES WILL BE LOST";
  return text;
}

}  // namespace geon::messaging
