#pragma once

#include <functional>

namespace geon::cli {

// Does task(0) ... task(count - 1), `jobs` at a time, in any order. A task must not throw.
void ParallelFor(int jobs, int count, const std::function<void(int)>& task);

}  // namespace geon::cli
