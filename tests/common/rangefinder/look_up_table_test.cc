#include "rangefinder/look_up_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

using sensor::Laser;
using testing::HasSubstr;

constexpr int kWidth = 32;
constexpr int kHeight = 24;

// A stripe by (3.9), every column a little different.
double Position(int line, double distance_m) {
  return 200.0 / distance_m - 190.0 + 239.5 + 0.05 * line;
}

std::vector<BoardObservation> Boards(double noise_px = 0.0, int count = 281,
                                     double step_m = 0.005) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<BoardObservation> boards;
  for (int k = 0; k < count; ++k) {
    BoardObservation board;
    board.distance_m = 0.65 + step_m * k;
    for (int line = 0; line < kWidth; ++line) {
      board.peaks.push_back({line, PeakReason::kFound,
                             Position(line, board.distance_m) + noise_px * noise(random), 100.0,
                             2.0});
    }
    boards.push_back(board);
  }
  return boards;
}

Result<Calibration> Build(const std::vector<BoardObservation>& boards) {
  return BuildLookUpTable(Laser::kHorizontal, kWidth, kHeight, 10, "2026-01-31", boards);
}

TEST(LookUpTableTest, DistancesBetweenSamplesAreInterpolated) {
  const auto calibration = Build(Boards());
  ASSERT_TRUE(calibration.ok()) << calibration.message();
  const LookUpTable& table = calibration->table;
  EXPECT_NEAR(table.last_distance_m(), 2.05, 1e-9);
  for (const double distance_m : {0.65, 0.6513, 0.9, 1.2345, 1.9999, 2.05}) {
    for (const int line : {0, 7, 31}) {
      const auto measured_m = table.Distance(line, Position(line, distance_m));
      ASSERT_TRUE(measured_m) << distance_m;
      EXPECT_NEAR(*measured_m, distance_m, 2e-5);
    }
  }
}

TEST(LookUpTableTest, StripesOutsideTheCalibratedRangeHaveNoDistance) {
  const auto calibration = Build(Boards());
  EXPECT_FALSE(calibration->table.Distance(3, Position(3, 0.64)));
  EXPECT_FALSE(calibration->table.Distance(3, Position(3, 2.06)));
  EXPECT_THROW((void)calibration->table.Distance(kWidth, 200.0), ContractViolation);
}

TEST(LookUpTableTest, PositionsMayRiseWithDistance) {
  auto boards = Boards();
  for (BoardObservation& board : boards) {
    for (StripePeak& peak : board.peaks) peak.position_px = 480.0 - peak.position_px;
  }
  const auto calibration = Build(boards);
  ASSERT_TRUE(calibration.ok()) << calibration.message();
  EXPECT_NEAR(*calibration->table.Distance(5, 480.0 - Position(5, 1.5)), 1.5, 2e-5);
}

TEST(LookUpTableTest, ReportTellsTheNoiseOfTheCalibration) {
  const auto exact = Build(Boards());
  EXPECT_LT(exact->report.rms_residual_px, 1e-9);
  const auto noisy = Build(Boards(0.02));
  ASSERT_TRUE(noisy.ok());
  EXPECT_NEAR(noisy->report.rms_residual_px, 0.02, 0.001);
  EXPECT_NEAR(noisy->report.rms_residual_at_1m_m, 0.02 / 200.0, 1e-5);
  EXPECT_GT(noisy->report.worst_line_rms_px, noisy->report.rms_residual_px);
}

TEST(LookUpTableTest, MissingEntriesAreBridged) {
  auto boards = Boards();
  for (size_t k = 50; k < 53; ++k) boards[k].peaks[4].reason = PeakReason::kSpeck;
  const auto calibration = Build(boards);
  ASSERT_TRUE(calibration.ok()) << calibration.message();
  EXPECT_EQ(calibration->report.missing, 3);
  EXPECT_TRUE(std::isnan(calibration->table.PositionAt(4, 51)));
  EXPECT_NEAR(*calibration->table.Distance(4, Position(4, 0.65 + 0.005 * 51)), 0.905, 1e-3);
}

TEST(LookUpTableTest, EntriesThatMoveTheWrongWayAreLeftOut) {
  auto boards = Boards();
  boards[100].peaks[9].position_px += 5.0;
  const auto calibration = Build(boards);
  ASSERT_TRUE(calibration.ok());
  EXPECT_EQ(calibration->report.reversed, 1);
  EXPECT_TRUE(std::isnan(calibration->table.PositionAt(9, 100)));
}

TEST(LookUpTableTest, BadSetUpsAreRefusedWithAReason) {
  auto gaps = Boards();
  for (size_t k = 0; k < 60; ++k) {
    for (StripePeak& peak : gaps[k].peaks) peak.reason = PeakReason::kTooFaint;
  }
  EXPECT_THAT(Build(gaps).message(), HasSubstr("show no stripe"));
  auto uneven = Boards();
  uneven[7].distance_m += 0.001;
  EXPECT_THAT(Build(uneven).message(), HasSubstr("steps must be equal: board 7"));
  auto short_line = Boards();
  short_line[2].peaks.pop_back();
  EXPECT_THAT(Build(short_line).message(), HasSubstr("board 2 has 31 lines, expected 32"));
  EXPECT_THAT(Build(Boards(0.0, 1)).message(), HasSubstr("at least two distances"));
  auto dead_column = Boards();
  for (BoardObservation& board : dead_column) board.peaks[11].reason = PeakReason::kTooFaint;
  CalibrationOptions tolerant;
  tolerant.max_missing_fraction_1 = 0.5;
  EXPECT_THAT(BuildLookUpTable(Laser::kHorizontal, kWidth, kHeight, 10, "", dead_column, tolerant)
                  .message(),
              HasSubstr("line 11 shows the stripe at fewer than two"));
}

}  // namespace
}  // namespace geon::rangefinder
