// What promises to allocate nothing, with the program's operator new counting.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "navigation/safe_polygon.h"

namespace {

std::atomic<int> allocations = 0;

}  // namespace

// Not inlined: g++ would see a free() of what operator new returned.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace geon::navigation {
namespace {

TEST(AllocationTest, ASafePolygonAllocatesNothing) {
  std::vector<Eigen::Vector2d> obstacles_m;
  for (int i = 0; i < 500; ++i) {
    obstacles_m.emplace_back((1.0 + 0.5 * std::sin(i)) * std::cos(0.1 * i),
                             (1.0 + 0.5 * std::sin(i)) * std::sin(0.1 * i));
  }
  const int before = allocations;
  const auto polygon = SafePolygon(obstacles_m, {});
  EXPECT_EQ(allocations, before);
  EXPECT_GT(polygon.vertices().size(), 4u);
  EXPECT_GT((std::make_unique<int>(1), allocations), before);  // the counter counts
}

}  // namespace
}  // namespace geon::navigation
