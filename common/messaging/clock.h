#pragma once

#include <cstdint>

namespace geon::messaging {

// The only two clocks of a daemon. Algorithms get their time as an argument.
int64_t Utime();            // microseconds since the epoch, for what goes on the bus
double MonotonicSeconds();  // for periods, deadlines and ages

}  // namespace geon::messaging
