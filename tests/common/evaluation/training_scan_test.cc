#include "evaluation/training_scan.h"

#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

TEST(TrainingScans, AreTheSameWhenMadeAgainAndOfOneShape) {
  const auto a = MakeTrainingScans(3, 5, 3), b = MakeTrainingScans(3, 5, 3);
  ASSERT_EQ(a.size(), 3U);
  for (size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(a[k].profiles.size(), 6U);
    for (size_t p = 0; p < 6; ++p) EXPECT_EQ(a[k].profiles[p].p_L_m, b[k].profiles[p].p_L_m);
    EXPECT_EQ(a[k].truth, a[0].truth);
  }
  EXPECT_NE(a[0].camera_position_L_m, a[1].camera_position_L_m);
  EXPECT_NE(a[0].camera_position_L_m, MakeTrainingScans(4, 5, 1)[0].camera_position_L_m);
}

TEST(TrainingScans, ShowTheTarget) {
  int scans = 0, full = 0;
  for (uint64_t t = 0; t < 20; ++t) {
    for (const sensor::ScanSet& scan : MakeTrainingScans(1, t, 4)) {
      ++scans;
      bool all = true;
      for (const sensor::RangeProfile& profile : scan.profiles) all &= profile.pixel.size() > 10;
      full += all ? 1 : 0;
    }
  }
  EXPECT_GT(full, 9 * scans / 10);
}

}  // namespace
}  // namespace geon::evaluation
