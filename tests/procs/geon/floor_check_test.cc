#include "procs/geon/floor_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace geon::cli {
namespace {

using sensor::Laser;
using testing::HasSubstr;
using State = SetupCheck::State;

// Stripes on a floor of the given heights and slope, with a geon's side in the middle.
std::vector<sensor::RangeProfile> Scans(double horizontal_m, double vertical_m, double slope_1) {
  std::vector<sensor::RangeProfile> profiles;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.001);
  for (int k = 0; k < 6; ++k) {
    sensor::RangeProfile& profile = profiles.emplace_back();
    profile.scan_id = 1 + k / 3;
    profile.laser = k % 2 == 0 ? Laser::kHorizontal : Laser::kVertical;
    const bool vertical = profile.laser == Laser::kVertical;
    for (int i = 0; i < 200; ++i) {
      const double along = -0.25 + 0.0025 * i;
      if (std::abs(along) < 0.1) {  // the geon, well above the floor
        profile.p_L_m.emplace_back(1.0, along, 0.15);
        continue;
      }
      const double x = vertical ? 1.2 + along : 1.1 + 0.1 * k;
      const double y = vertical ? 0.05 * k : along;
      profile.p_L_m.emplace_back(
          x, y, (vertical ? vertical_m : horizontal_m) + slope_1 * (x - 1.2) + noise(random));
    }
  }
  return profiles;
}

TEST(FloorCheck, AFloorWhereItShouldBeIsGood) {
  const FloorAgreement floor = MeasureFloor(Scans(0.001, 0.0, 0.0));
  EXPECT_EQ(floor.scans, 2);
  EXPECT_NEAR(floor.horizontal_m, 0.001, 3e-4);
  EXPECT_TRUE(floor.leans_known);
  EXPECT_EQ(JudgeFloor(floor).state, State::kGood);
}

TEST(FloorCheck, ATurnedLaserIsToldFromAMovedHead) {
  const SetupCheck laser = JudgeFloor(MeasureFloor(Scans(0.009, 0.0, 0.0)));
  EXPECT_EQ(laser.state, State::kBad);
  EXPECT_THAT(laser.text, HasSubstr("the lasers disagree by"));
  const SetupCheck head = JudgeFloor(MeasureFloor(Scans(-0.011, -0.011, 0.0)));
  EXPECT_EQ(head.state, State::kBad);
  EXPECT_THAT(head.text, HasSubstr("the head's height or tilt has changed"));
  const SetupCheck leaning = JudgeFloor(MeasureFloor(Scans(0.0, 0.0, 0.03)));
  EXPECT_EQ(leaning.state, State::kBad);
  EXPECT_THAT(leaning.text, HasSubstr("leans"));
}

TEST(FloorCheck, NoFloorIsANote) {
  const SetupCheck check = JudgeFloor(MeasureFloor(Scans(0.2, 0.2, 0.0)));
  EXPECT_EQ(check.state, State::kNote);
  EXPECT_THAT(check.text, HasSubstr("show no floor"));
}

TEST(FloorCheck, TheSampleLogAgreesWithItsCalibration) {
  const auto profiles =
      FloorProfiles(std::filesystem::path(GEON_SOURCE_DIR) / "logs/sample.lcmlog");
  ASSERT_TRUE(profiles.ok()) << profiles.message();
  EXPECT_GE(profiles->size(), 4U);
  EXPECT_NE(JudgeFloor(MeasureFloor(*profiles)).state, State::kBad)
      << JudgeFloor(MeasureFloor(*profiles)).text;
}

TEST(FloorCheck, AMissingLogIsAnError) { EXPECT_FALSE(FloorProfiles("/nowhere.lcmlog").ok()); }

}  // namespace
}  // namespace geon::cli
