#include "sim/bumper_ring.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::sim {
namespace {

uint32_t Settled(BumperRing* ring, const std::vector<DiscContact>& contacts,
                 double base_W_rad = 0.0) {
  for (double t_s = 0.0; t_s < 0.05; t_s += 0.001) ring->Advance(t_s, contacts, base_W_rad);
  return ring->mask();
}

TEST(BumperRing, TheStripThatIsTouchedReads) {
  BumperRing ring({}, 1);
  EXPECT_EQ(Settled(&ring, {{RadiansFromDegrees(36.0), 0.0}}), 1u << 2);
  EXPECT_TRUE(ring.any_pressed());
  BumperRing free({}, 1);
  EXPECT_EQ(Settled(&free, {{0.0, 0.02}}), 0u);
  EXPECT_FALSE(free.any_pressed());
}

TEST(BumperRing, ATouchBetweenTwoStripsPressesBoth) {
  BumperRing ring({}, 1);
  EXPECT_EQ(Settled(&ring, {{RadiansFromDegrees(-9.0), -0.001}}), (1u << 0) | (1u << 19));
}

TEST(BumperRing, TurnsWithTheBase) {
  BumperRing ring({}, 1);
  EXPECT_EQ(Settled(&ring, {{kPi / 2, 0.0}}, kPi / 2), 1u);
}

TEST(BumperRing, ChattersBeforeItSettles) {
  BumperRing ring({}, 4);
  int changes = 0;
  uint32_t before = 0;
  double settled_s = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double t_s = i * 0.001;
    ring.Advance(t_s, {{0.0, 0.0}}, 0.0);
    if (ring.mask() != before) {
      ++changes;
      settled_s = t_s;
    }
    before = ring.mask();
  }
  EXPECT_GE(changes, 3);
  EXPECT_GE(settled_s, 0.005);
  EXPECT_LE(settled_s, 0.031);
  EXPECT_EQ(before, 1u);
}

TEST(BumperRing, AStuckSwitchIsAlwaysClosed) {
  BumperRingOptions options;
  options.stuck = 7;
  BumperRing ring(options, 1);
  EXPECT_EQ(Settled(&ring, {}), 1u << 7);
  EXPECT_FALSE(ring.any_pressed());
  options.stuck = 20;
  EXPECT_THROW(BumperRing(options, 1), ContractViolation);
}

}  // namespace
}  // namespace geon::sim
