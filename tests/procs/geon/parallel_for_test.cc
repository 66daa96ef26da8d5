#include "procs/geon/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace geon::cli {
namespace {

TEST(ParallelFor, DoesEveryTaskOnce) {
  for (int jobs : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(50);
    ParallelFor(jobs, 50, [&](int k) { ++done[static_cast<size_t>(k)]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(ParallelFor, DoesNothingOfNoTasks) {
  ParallelFor(3, 0, [](int) { FAIL(); });
}

}  // namespace
}  // namespace geon::cli
