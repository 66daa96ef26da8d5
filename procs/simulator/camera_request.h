#pragma once

#include <cstdint>
#include <span>

#include "base/status.h"

namespace geon::simulator {

// What a client asks of a camera over its frame socket, in a message of one part:
//   {"exposure_us":int}
// The exposure of the frames to come, in seconds. Trusts nothing; error: why the bytes are no
// request.
Result<double> ParseExposureRequest(std::span<const uint8_t> bytes);

}  // namespace geon::simulator
