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
  options.crosstalk_probability_1 = 0.0;
  return options;
}

void Fire(SonarRing* ring, double duration_s, const RingPose& pose = {}) {
  for (double t_s = 0.0; t_s < duration_s; t_s += 0.004) ring->Advance(t_s, pose);
}

// A single upright pole of the radius of the thesis's cylinders.
class Pole : public FreeSpace {
 public:
  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W) const override {
    const Eigen::Vector2d to_axis = Eigen::Vector2d(2.0, 0.0) - origin_W_m.head<2>();
    const Eigen::Vector2d direction = direction_W.head<2>().normalized();
    const double along_m = to_axis.dot(direction);
    const double off2 = to_axis.squaredNorm() - along_m * along_m;
    if (along_m < 0.0 || off2 > kRadius_m * kRadius_m) return std::nullopt;
    const double flat_m = along_m - std::sqrt(kRadius_m * kRadius_m - off2);
    const Eigen::Vector2d normal =
        (origin_W_m.head<2>() + flat_m * direction - Eigen::Vector2d(2.0, 0.0)) / kRadius_m;
    return RayHit{flat_m / direction_W.head<2>().norm(), {normal.x(), normal.y(), 0.0}, 0.8};
  }
  static constexpr double kRadius_m = 0.075;
};

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

TEST(SonarRing, ASlantedWallSendsTheSoundAway) {
  // The wall's normal is 60 degrees off the axis: no ray of the cone meets it squarely.
  const Eigen::Vector2d normal(-std::cos(kPi / 3), -std::sin(kPi / 3));
  const Walls slanted({{normal, -1.0}});
  const SonarRing ring(Quiet(), 1, &slanted);
  EXPECT_FALSE(ring.Echo_m(0, {}).has_value());
  const Eigen::Vector2d square(-std::cos(0.2), -std::sin(0.2));
  const Walls nearly_square({{square, -1.5}});
  const SonarRing other(Quiet(), 1, &nearly_square);
  EXPECT_TRUE(other.Echo_m(0, {}).has_value());
}

TEST(SonarRing, HearsAPole) {
  const Pole world;
  const SonarRing ring(Quiet(), 1, &world);
  const auto echo_m = ring.Echo_m(0, {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 2.0 - 0.225 - Pole::kRadius_m, 0.06);
}

// A slanted panel that sends all sound away but for the edge where it ends.
class Panel : public Walls {
 public:
  Panel() : Walls({{{-std::cos(kPi / 3), -std::sin(kPi / 3)}, -0.6}}) {}
  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W) const override {
    const auto hit = Walls::CastRay(origin_W_m, direction_W);
    if (!hit || (origin_W_m + hit->distance_m * direction_W).y() < 0.05) return std::nullopt;
    return hit;
  }
};

TEST(SonarRing, HearsTheEdgeOfAPanelFaintly) {
  const Panel world;
  SonarRingOptions options = Quiet();
  const SonarRing ring(options, 1, &world);
  const auto echo_m = ring.Echo_m(0, {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 0.6 / 0.5 - 0.225 - 0.05 * std::sqrt(3.0), 0.1);
  options.edge_echo_1 = 0.0;
  EXPECT_FALSE(SonarRing(options, 1, &world).Echo_m(0, {}).has_value());
}

TEST(SonarRing, ACornerAnswersByWayOfBothWalls) {
  // A right-angled corner looked into along its bisector: each wall is met at 45 degrees.
  const double s = std::sqrt(0.5);
  const Walls corner({{{-s, s}, -1.2}, {{-s, -s}, -1.2}});
  SonarRingOptions options = Quiet();
  SonarRing ring(options, 1, &corner);
  const auto echo_m = ring.Echo_m(0, {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 1.2 / s - 0.225, 0.1);
  options.double_bounce = false;
  const SonarRing simple(options, 1, &corner);
  EXPECT_FALSE(simple.Echo_m(0, {}).has_value());
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

TEST(SonarRing, TooNearAWallReadsTheMinimumOrALaterEcho) {
  const Walls world = WallAhead(0.25);
  SonarRing ring(Quiet(), 3, &world);
  ring.Configure(1, {0}, 0.0);
  std::set<bool> kinds;
  for (double t_s = 0.0; t_s < 2.0; t_s += 0.004) {
    ring.Advance(t_s, {});
    const int reading = ring.readings_in()[0];
    if (reading == SonarRing::kNoEcho_in) continue;
    EXPECT_GE(reading, SonarRing::kNearest_in);
    EXPECT_LE(reading, 26);
    kinds.insert(reading > SonarRing::kNearest_in);
  }
  EXPECT_EQ(kinds.size(), 2u) << "both kinds happen";
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
