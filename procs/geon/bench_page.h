#pragma once

#include <string>

#include "procs/geon/bench_record.h"

namespace geon::cli {

// What the bench found, as one self-contained HTML page: the tables at each range, times,
// placement, and the runs that went wrong with what the camera saw and what the stripes measured.
std::string BenchPage(const BenchRecord& record);

}  // namespace geon::cli
