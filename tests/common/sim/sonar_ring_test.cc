#include "sim/sonar_ring.h"

#include <gtest/gtest.h>

#include <set>

#include "base/contracts.h"
#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

constexpr double kSonarInch_m = 0.0254;

// A wall across the x axis, `away_m` in front of sensor 0.
Walls WallAhead(double away_m) { return Walls({{{-1.0, 0.0}, -(away_m + 0.225)}}); }

SonarRingOptions Quiet() {
  SonarRingOptions options;
  options.fading_1 = options.deaf_probability_1 = options.specular_probability_1 =
      options.crosstalk_probability_1 = 0.0;
  return options;
}

void Fire(SonarRing* ring, double duration_s, const RingPose& pose = {}) {
  for (double t_s = 0.0; t_s < duration_s; t_s += 0.004) ring->Advance(t_s, pose);
}

TEST(SonarRing, MeasuresAWallInWholeInches) {
  const Walls world = WallAhead(2.0);
  SonarRing ring(Quiet(), 1, &world);
  Fire(&ring, 1.0);
  EXPECT_NEAR(ring.readings_in()[0] * kSonarInch_m, 2.0, 0.08);
}

TEST(SonarRing, SaysNothingIsThereInTheOpen) {
  const FreeSpace world;
  SonarRing ring(Quiet(), 1, &world);
  Fire(&ring, 1.0);
  for (const uint8_t reading : ring.readings_in()) EXPECT_EQ(reading, SonarRing::kNoEcho_in);
}

TEST(SonarRing, FiresOneAfterAnotherInItsOrder) {
  const Walls world = WallAhead(1.0);
  SonarRing ring(Quiet(), 1, &world);
  ring.Configure(15, {5, 0, 255, 1}, 0.0);
  Fire(&ring, 0.1);
  EXPECT_EQ(ring.readings_in()[0], SonarRing::kNoEcho_in) << "its turn is at 0.12 s";
  Fire(&ring, 0.13);
  EXPECT_LT(ring.readings_in()[0], 60);
  EXPECT_EQ(ring.readings_in()[1], SonarRing::kNoEcho_in) << "after the 255";
}

TEST(SonarRing, KeepsAStaleReadingUntilItsNextTurn) {
  const Walls world = WallAhead(1.0);
  SonarRing ring(Quiet(), 1, &world);
  Fire(&ring, 0.07);  // only sensor 0 has fired
  const int before = ring.readings_in()[0];
  EXPECT_LT(before, 60);
  RingPose far;
  far.center_W_m = {-2.0, 0.0};
  for (double t_s = 0.072; t_s < 1.0; t_s += 0.004) ring.Advance(t_s, far);
  EXPECT_EQ(ring.readings_in()[0], before);
  for (double t_s = 1.0; t_s < 1.1; t_s += 0.004) ring.Advance(t_s, far);
  EXPECT_NEAR(ring.readings_in()[0] * kSonarInch_m, 3.0, 0.15);
}

// What sensor 0 reads, ping after ping.
std::vector<int> Readings(const SonarRingOptions& options, const Walls& world, int count) {
  SonarRing ring(options, 7, &world);
  ring.Configure(1, {0}, 0.0);
  std::vector<int> readings;
  for (int k = 1; k <= count; ++k) {
    ring.Advance(0.004 * k, {});
    readings.push_back(ring.readings_in()[0]);
  }
  return readings;
}

TEST(SonarRing, TooNearAWallReadsTwoOrThreeTimesTooFarOrTheMinimum) {
  for (const auto& [away_m, times] : {std::pair{0.30, 2}, {0.18, 3}}) {
    int later = 0, least = 0;
    for (const int reading : Readings(Quiet(), WallAhead(away_m), 1000)) {
      (reading == SonarRing::kNearest_in ? least : later) += 1;
      if (reading != SonarRing::kNearest_in) {
        EXPECT_NEAR(reading * kSonarInch_m, times * away_m, times * 0.045);
      }
    }
    EXPECT_NEAR(later, 800, 60);
    EXPECT_NEAR(least, 200, 60);
  }
}

TEST(SonarRing, NoiseIsAtLeastHalfAnInch) {
  double squares_in2 = 0.0;
  for (const int reading : Readings(Quiet(), WallAhead(30 * kSonarInch_m), 2000)) {
    squares_in2 += std::pow(reading - 30.0, 2) / 2000.0;
  }
  // And a twelfth for the whole inches.
  EXPECT_NEAR(std::sqrt(squares_in2), std::sqrt(0.25 + 1.0 / 12.0), 0.05);
}

TEST(SonarRing, AnEchoAtTheEdgeOfHearingComesAndGoes) {
  SonarRingOptions options = Quiet();
  const double away_m = 5.0;
  options.echo.reach_m = away_m;
  const auto heard = [&] {
    int count = 0;
    for (const int reading : Readings(options, WallAhead(away_m), 1000)) {
      count += reading < SonarRing::kNoEcho_in ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(heard(), 1000);
  options.fading_1 = 0.5;
  EXPECT_NEAR(heard(), 500, 80);
}

TEST(SonarRing, AFewReadingsAreSilentOrFarther) {
  SonarRingOptions options = Quiet();
  options.deaf_probability_1 = 0.05;
  options.specular_probability_1 = 0.1;
  int silent = 0, farther = 0;
  for (const int reading : Readings(options, WallAhead(2.0), 2000)) {
    silent += reading == SonarRing::kNoEcho_in ? 1 : 0;
    farther += reading > 85 && reading < SonarRing::kNoEcho_in ? 1 : 0;
  }
  EXPECT_NEAR(silent, 100, 40);
  EXPECT_NEAR(farther, 190, 50);
}

TEST(SonarRing, NoiseIsAboutOnePercent) {
  const Walls world = WallAhead(4.0);
  SonarRing ring(Quiet(), 7, &world);
  ring.Configure(1, {0}, 0.0);
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (double t_s = 0.004; t_s < 8.0; t_s += 0.004) {
    ring.Advance(t_s, {});
    const double reading = ring.readings_in()[0];
    if (reading == SonarRing::kNoEcho_in) continue;
    sum += reading;
    squares += reading * reading;
    ++count;
  }
  const double mean = sum / count;
  const double sigma = std::sqrt(squares / count - mean * mean);
  EXPECT_NEAR(mean * kSonarInch_m, 4.0, 0.06);
  EXPECT_NEAR(sigma / mean, 0.01, 0.003);
}

TEST(SonarRing, ADeadSensorSaysTheSameForEver) {
  const Walls world = WallAhead(1.0);
  SonarRingOptions options = Quiet();
  options.dead = {{0, 17}, {4, 255}};
  SonarRing ring(options, 1, &world);
  Fire(&ring, 1.0);
  EXPECT_EQ(ring.readings_in()[0], 17);
  EXPECT_EQ(ring.readings_in()[4], 255);
  options.dead = {{16, 17}};
  EXPECT_THROW(SonarRing(options, 1, &world), ContractViolation);
}

TEST(SonarRing, CrosstalkMakesPhantomsNearerThanTheWall) {
  const Walls world = WallAhead(4.0);
  SonarRingOptions options = Quiet();
  options.crosstalk_probability_1 = 0.2;
  SonarRing ring(options, 5, &world);
  ring.Configure(1, {0}, 0.0);
  int phantoms = 0;
  for (double t_s = 0.004; t_s < 4.0; t_s += 0.004) {
    ring.Advance(t_s, {});
    phantoms += ring.readings_in()[0] < 140 ? 1 : 0;
  }
  EXPECT_GT(phantoms, 100);
  EXPECT_LT(phantoms, 300);
}

TEST(SonarRing, TheSameSeedGivesTheSameReadings) {
  const Walls world = WallAhead(3.0);
  SonarRing a({}, 11, &world);
  SonarRing b({}, 11, &world);
  SonarRing c({}, 12, &world);
  bool differs = false;
  for (double t_s = 0.0; t_s < 20.0; t_s += 0.004) {
    a.Advance(t_s, {});
    b.Advance(t_s, {});
    c.Advance(t_s, {});
    ASSERT_EQ(a.readings_in(), b.readings_in());
    differs |= a.readings_in() != c.readings_in();
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace geon::sim
