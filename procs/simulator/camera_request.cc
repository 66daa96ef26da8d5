#include "procs/simulator/camera_request.h"

#include <nlohmann/json.hpp>

namespace geon::simulator {

Result<double> ParseExposureRequest(std::span<const uint8_t> bytes) {
  constexpr size_t kLongest = 256;
  constexpr double kMost_us = 10e6;
  if (bytes.size() > kLongest) return Status::Error("a request of more than 256 bytes");
  const nlohmann::json request =
      nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, /*allow_exceptions=*/false);
  if (!request.is_object()) return Status::Error("a request that is no JSON object");
  const auto it = request.find("exposure_us");
  if (it == request.end() || !it->is_number_integer()) {
    return Status::Error("a request without an integer \"exposure_us\"");
  }
  const auto exposure_us = it->get<double>();
  if (!(exposure_us >= 1.0 && exposure_us <= kMost_us)) {
    return Status::Error("a request whose \"exposure_us\" is not within 1..10000000");
  }
  return 1e-6 * exposure_us;
}

}  // namespace geon::simulator
