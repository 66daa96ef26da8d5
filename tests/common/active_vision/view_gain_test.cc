#include "active_vision/view_gain.h"

#include <gtest/gtest.h>

namespace geon::active_vision {
namespace {

using Posterior = std::array<double, kGeonLabelCount>;

TEST(ViewGainTest, NothingIsGainedWhereNothingIsOpen) {
  const Posterior sure = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0};
  for (int turns = 1; turns <= kViewTurns; ++turns) EXPECT_DOUBLE_EQ(ViewGain(sure, turns), 0.0);
}

TEST(ViewGainTest, TheLessIsKnownTheMoreIsGained) {
  const Posterior doubtful = {0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0};
  const Posterior nearly = {0.9, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (int turns = 1; turns <= kViewTurns; ++turns) {
    EXPECT_GT(ViewGain(doubtful, turns), ViewGain(nearly, turns));
    EXPECT_GT(ViewGain(nearly, turns), 0.0);
  }
}

TEST(ViewGainTest, SixtyDegreesTellMoreThanARightAngleOrTheFarSide) {
  const Posterior doubtful = {0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_GT(ViewGain(doubtful, 2), ViewGain(doubtful, 3));
  EXPECT_GT(ViewGain(doubtful, 2), ViewGain(doubtful, 6));
}

TEST(ViewGainTest, OtherTurnsAreRefused) {
  EXPECT_ANY_THROW(ViewGain({}, 0));
  EXPECT_ANY_THROW(ViewGain({}, kViewTurns + 1));
}

}  // namespace
}  // namespace geon::active_vision
