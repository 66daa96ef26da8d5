// Any bytes as a request to a simulated camera: refused with a reason, or an exposure it can take.
#include <cstdint>
#include <cstdlib>

#include "procs/simulator/camera_request.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto exposure_s = geon::simulator::ParseExposureRequest({data, size});
  if (exposure_s.ok() ? !(*exposure_s >= 1e-6 && *exposure_s <= 10.0)
                      : exposure_s.message().empty()) {
    std::abort();
  }
  return 0;
}
