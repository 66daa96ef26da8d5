#include "mission/head.h"

#include <gtest/gtest.h>

namespace geon::mission {
namespace {

sensor::PtuState At(double pan_rad, int64_t command_id, bool moving = false) {
  sensor::PtuState state;
  state.status = sensor::DeviceStatus::kReady;
  state.pan_rad = pan_rad;
  state.command_id = command_id;
  state.moving = moving;
  return state;
}

TEST(HeadTest, RepeatsTheCommandUntilThePtuHasHeardIt) {
  Head head(100);
  EXPECT_FALSE(head.Command(0.0, At(0.0, 0)).has_value());
  head.Point({0.5, 0.0});
  const auto first = head.Command(0.0, At(0.0, 0));
  ASSERT_TRUE(first.has_value());
  EXPECT_GT(first->command_id, 100);
  EXPECT_FALSE(head.Command(0.1, At(0.0, 0)).has_value());
  EXPECT_TRUE(head.Command(0.25, At(0.0, 0)).has_value());
  EXPECT_FALSE(head.Command(0.6, At(0.0, first->command_id)).has_value());
  // One that restarted has forgotten.
  EXPECT_TRUE(head.Command(0.9, At(0.0, 0)).has_value());
}

TEST(HeadTest, KeepsOnWhatMovesALittleWithoutAnotherWish) {
  Head head(1);
  head.Keep({0.5, -0.2}, 0.05);
  const auto first = head.Command(0.0, At(0.0, 0));
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->pan_rad, 0.5);
  head.Keep({0.54, -0.16}, 0.05);
  EXPECT_EQ(head.wanted()->pan_rad, 0.5);
  for (const active_vision::HeadAngles& off :
       {active_vision::HeadAngles{0.56, -0.2}, active_vision::HeadAngles{0.56, -0.26}}) {
    head.Keep(off, 0.05);
    EXPECT_EQ(*head.wanted(), off) << "off in one axis is off";
  }
}

TEST(HeadTest, AnotherSpeedIsAnotherWish) {
  Head head(1);
  head.Point({0.5, 0.0});
  const auto fast = head.Command(0.0, At(0.0, 0));
  EXPECT_EQ(fast->speed_rad_s, 0.0);
  head.Point({0.5, 0.0}, 0.25);
  const auto slow = head.Command(0.1, At(0.0, fast->command_id));
  ASSERT_TRUE(slow.has_value());
  EXPECT_EQ(slow->speed_rad_s, 0.25);
  EXPECT_GT(slow->command_id, fast->command_id);
}

TEST(HeadTest, SettledMeansThisCommandThereAndStillForSomeTime) {
  Head head(1);
  head.Point({0.5, 0.0});
  const int64_t id = head.Command(0.0, At(0.0, 0))->command_id;
  EXPECT_FALSE(head.Settled(0.1, At(0.5, 0), 0.1));         // an older command's place
  EXPECT_FALSE(head.Settled(0.2, At(0.5, id, true), 0.1));  // still moving
  EXPECT_FALSE(head.Settled(0.3, At(0.4, id), 0.1));        // not there
  EXPECT_FALSE(head.Settled(0.4, At(0.5, id), 0.1));
  EXPECT_TRUE(head.Settled(0.51, At(0.5, id), 0.1));
  head.Point({0.5, 0.0});  // the same wish is no news
  EXPECT_TRUE(head.Settled(0.6, At(0.5, id), 0.1));
  head.Point({0.6, 0.0});
  EXPECT_FALSE(head.Settled(0.7, At(0.5, id), 0.1));
}

}  // namespace
}  // namespace geon::mission
