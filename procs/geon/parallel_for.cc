#include "procs/geon/parallel_for.h"

#include <atomic>
#include <thread>
#include <vector>

namespace geon::cli {

void ParallelFor(int jobs, int count, const std::function<void(int)>& task) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int k = next++; k < count; k = next++) task(k);
  };
  std::vector<std::jthread> workers;
  for (int job = 1; job < jobs; ++job) workers.emplace_back(work);
  work();
}

}  // namespace geon::cli
