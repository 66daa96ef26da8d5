#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "base/angles.h"
#include "sim/sonar_ring.h"
#include "sim/world_scene.h"
#include "tests/real_data/real_data.h"

namespace geon {
namespace {

using Eigen::Vector2d;

constexpr double kMost_m = 5.0;  // what the real ring reads when it hears nothing
constexpr double kJump_m = 0.5;
constexpr double kRate_hz = 9.0;  // of each sonar

// Readings of a ring round a robot, a row for each time. Sonars count counter-clockwise; bearings
// are from straight ahead, positive to the left.
struct RingLog {
  double first_bearing_rad = 0.0;
  std::vector<std::vector<double>> rows_m;

  size_t sonars() const { return rows_m.front().size(); }
  double At(size_t row, size_t sonar) const { return std::min(kMost_m, rows_m[row][sonar]); }
};

enum Side { kAhead = 0, kLeft, kBehind, kRight };
constexpr std::array kSides = {kAhead, kLeft, kBehind, kRight};

Side SideOf(const RingLog& log, size_t sonar) {
  const double bearing_rad = log.first_bearing_rad + 2.0 * kPi * static_cast<double>(sonar) /
                                                         static_cast<double>(log.sonars());
  const double quarters_1 = bearing_rad / (kPi / 2) + 0.5 + 1e-9;
  return static_cast<Side>((static_cast<int>(std::floor(quarters_1)) + 4) % 4);
}

struct Shares {
  double silent_1 = 0.0;  // of the readings: the maximum
  double jump_1 = 0.0;    // of the steps from a sonar's reading to its next
  // Of the readings between two before and two after that agree: something else.
  double stray_1 = 0.0;
};

// Of the sonars of one side, or of all.
Shares SharesOf(const RingLog& log, std::optional<Side> side = {}) {
  int readings = 0, silent = 0, steps = 0, jumps = 0, steady = 0, strays = 0;
  for (size_t k = 0; k < log.sonars(); ++k) {
    if (side && SideOf(log, k) != *side) continue;
    for (size_t row = 2; row + 2 < log.rows_m.size(); ++row) {
      const double now_m = log.At(row, k);
      ++readings, ++steps;
      silent += now_m == kMost_m ? 1 : 0;
      jumps += std::abs(now_m - log.At(row - 1, k)) > kJump_m ? 1 : 0;
      const auto [least_m, most_m] = std::minmax(
          {log.At(row - 2, k), log.At(row - 1, k), log.At(row + 1, k), log.At(row + 2, k)});
      if (most_m > 2.0 || most_m - least_m > 0.1) continue;
      ++steady;
      strays += std::abs(now_m - least_m) > kJump_m ? 1 : 0;
    }
  }
  return {1.0 * silent / readings, 1.0 * jumps / steps, 1.0 * strays / steady};
}

// The way of the log's robot as far as its readings tell: clockwise along the walls of a room of
// about 4.4 x 5.3 m (what it reads to the left and right, ahead and behind adds up to the sides),
// its middle 0.92 m off them, at 0.15 m/s and swaying by ten degrees; in the corners it turns on
// the spot at 11 degrees a second.
class Tour {
 public:
  explicit Tour(const Vector2d& room_m) {
    constexpr double kOff_m = 0.92;
    const Vector2d far_m = room_m.array() - kOff_m;
    corners_m_ = {Vector2d(kOff_m, kOff_m), Vector2d(kOff_m, far_m.y()), far_m,
                  Vector2d(far_m.x(), kOff_m)};
  }
  double round_s() const {
    double time_s = 0.0;
    for (size_t leg = 0; leg < 4; ++leg) time_s += Length_m(leg) / kSpeed_m_s + kTurn_s;
    return time_s;
  }
  sim::RingPose At(double time_s) const {
    time_s = std::fmod(time_s, round_s());
    size_t leg = 0;
    while (time_s >= Length_m(leg) / kSpeed_m_s + kTurn_s) {
      time_s -= Length_m(leg++) / kSpeed_m_s + kTurn_s;
    }
    const double heading_rad = kPi / 2 * (1.0 - static_cast<double>(leg));
    const double driven_m = std::min(kSpeed_m_s * time_s, Length_m(leg));
    const Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
    sim::RingPose pose;
    pose.center_W_m = corners_m_[leg] + driven_m * along;
    const double phase_rad = 2.0 * kPi * driven_m / Length_m(leg);
    const double turned_s = std::max(0.0, time_s - Length_m(leg) / kSpeed_m_s);
    pose.bearing_W_rad =
        heading_rad + kSway_rad * std::sin(2.0 * phase_rad) - kPi / 2 * turned_s / kTurn_s;
    return pose;
  }

 private:
  static constexpr double kSpeed_m_s = 0.15;
  static constexpr double kTurn_s = 90.0 / 11.0;
  static constexpr double kSway_rad = RadiansFromDegrees(10.0);
  double Length_m(size_t leg) const { return (corners_m_[(leg + 1) % 4] - corners_m_[leg]).norm(); }
  std::array<Vector2d, 4> corners_m_;
};

// 24 sonars of a SCITOS G5 that follows the walls of a room clockwise, four times (UCI "Wall-
// Following Robot Navigation Data"). Whatever the data's description says, its first sonar looks
// backward and the others follow counter-clockwise: see the first test.
class SonarLogTest : public RealDataTest {
 protected:
  RingLog Real() {
    RingLog log;
    log.first_bearing_rad = -kPi;
    for (const auto& row : ReadCsv("logs/sensor_readings_24.data")) {
      log.rows_m.emplace_back();
      for (size_t k = 0; k < 24; ++k) log.rows_m.back().push_back(std::stod(row[k]));
      does_.push_back(row[24]);
    }
    EXPECT_GT(log.rows_m.size(), 5000U);
    return log;
  }
  static const RingLog& Simulated() {
    static const RingLog log = Simulate();
    return log;
  }
  // The simulated ring on the like of that way, fired as fast. One cupboard stands in the room.
  static RingLog Simulate() {
    sim::World world;
    world.pen_size_m = {4.4, 5.3};
    world.wall_height_m = 2.5;
    sim::WorldObject cupboard;
    cupboard.shape = sim::BoxShape{{0.6, 0.4, 1.2}};
    cupboard.x_m = 2.4;
    cupboard.y_m = 2.0;
    cupboard.yaw_rad = 0.4;
    world.objects.push_back(cupboard);
    const auto scene = *BuildScene(world);
    sim::SonarRingOptions options;
    options.tick_s = 1.0 / (kRate_hz * sim::SonarRing::kCount * options.rate);
    sim::SonarRing ring(options, 24, scene.get());
    const Tour tour(world.pen_size_m);
    RingLog log;
    constexpr int kRounds = 2, kCallsPerRow = 2 * sim::SonarRing::kCount;
    const int rows = static_cast<int>(kRounds * tour.round_s() * kRate_hz);
    for (int call = 0; call < rows * kCallsPerRow; ++call) {
      const double time_s = call / (kRate_hz * kCallsPerRow);
      ring.Advance(time_s, tour.At(time_s));
      if (call % kCallsPerRow != kCallsPerRow - 1 || call < 2 * kCallsPerRow) continue;
      log.rows_m.emplace_back();
      for (const uint8_t reading_in : ring.readings_in()) {
        log.rows_m.back().push_back(0.0254 * reading_in);
      }
    }
    return log;
  }
  void Record(const std::string& name, double real_1, double simulated_1) {
    RecordProperty("real_" + name, std::to_string(real_1));
    RecordProperty("simulated_" + name, std::to_string(simulated_1));
  }

  std::vector<std::string> does_;  // what the real robot does, by row
};

TEST_F(SonarLogTest, TheLogsFirstSonarLooksBackwardAndTheOthersFollowCounterClockwise) {
  const RingLog log = Real();
  std::array<double, 24> change_m{};
  double later_1 = 0.0;
  for (size_t row = 1; row < log.rows_m.size(); ++row) {
    for (size_t k = 0; k < 24; ++k) {
      const double step_m = log.At(row, k) - log.At(row - 1, k);
      if (does_[row] == "Move-Forward" && std::abs(step_m) < 0.1) change_m[k] += step_m;
      // Turning right, what one sonar hears the next one to the left hears afterwards.
      if (does_[row] != "Sharp-Right-Turn" || row < 12) continue;
      const auto same = [&](size_t other) {
        return std::abs(log.At(row - 12, other % 24) - log.At(row, k)) < 0.05 ? 1.0 : 0.0;
      };
      later_1 += same(k + 23) - same(k + 1);
    }
  }
  EXPECT_LT(change_m[12], -1.0) << "ahead: it comes nearer";
  EXPECT_GT(change_m[0], 1.0) << "behind";
  EXPECT_GT(later_1, 0.0);
}

TEST_F(SonarLogTest, TheSimulatedRingIsSilentAboutAsOften) {
  const RingLog real = Real();
  const RingLog& simulated = Simulated();
  const double real_1 = SharesOf(real).silent_1, simulated_1 = SharesOf(simulated).silent_1;
  Record("silent", real_1, simulated_1);
  EXPECT_GT(simulated_1, 0.9 * real_1);
  EXPECT_LT(simulated_1, 1.4 * real_1);
  // Least towards the wall that is followed, and everywhere within half and double.
  for (const Side side : kSides) {
    const double real_side_1 = SharesOf(real, side).silent_1;
    const double simulated_side_1 = SharesOf(simulated, side).silent_1;
    Record("silent_side_" + std::to_string(side), real_side_1, simulated_side_1);
    EXPECT_GE(simulated_side_1, SharesOf(simulated, kLeft).silent_1) << side;
    EXPECT_GT(simulated_side_1, 0.5 * real_side_1) << side;
    EXPECT_LT(simulated_side_1, 2.0 * real_side_1) << side;
  }
}

TEST_F(SonarLogTest, TheSimulatedRingJumpsAboutAsOften) {
  const RingLog real = Real();
  const RingLog& simulated = Simulated();
  const double real_1 = SharesOf(real).jump_1, simulated_1 = SharesOf(simulated).jump_1;
  Record("jump", real_1, simulated_1);
  EXPECT_GT(simulated_1, 0.9 * real_1);
  EXPECT_LT(simulated_1, 1.4 * real_1);
  for (const Side side : kSides) {
    const double real_side_1 = SharesOf(real, side).jump_1;
    const double simulated_side_1 = SharesOf(simulated, side).jump_1;
    Record("jump_side_" + std::to_string(side), real_side_1, simulated_side_1);
    EXPECT_GE(simulated_side_1, SharesOf(simulated, kLeft).jump_1) << side;
    EXPECT_GT(simulated_side_1, 0.4 * real_side_1) << side;
    EXPECT_LT(simulated_side_1, 2.0 * real_side_1) << side;
  }
}

TEST_F(SonarLogTest, AmongReadingsThatAgreeOneIsAstrayAboutAsOften) {
  const double real_1 = SharesOf(Real()).stray_1, simulated_1 = SharesOf(Simulated()).stray_1;
  Record("stray", real_1, simulated_1);
  EXPECT_GT(simulated_1, 0.7 * real_1);
  EXPECT_LT(simulated_1, 3.0 * real_1);
}

}  // namespace
}  // namespace geon
