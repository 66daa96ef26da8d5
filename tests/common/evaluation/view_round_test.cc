#include "evaluation/view_round.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "evaluation/training_scan.h"

namespace geon::evaluation {
namespace {

TEST(ScanRound, IsTheSameWhenMadeAgainAndNoOther) {
  const auto a = ScanRound(3, 5, ShapeKind::kTraining), b = ScanRound(3, 5, ShapeKind::kTraining);
  ASSERT_EQ(a.size(), static_cast<size_t>(kRoundViews));
  for (size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].profiles[1].p_L_m, b[k].profiles[1].p_L_m);
    EXPECT_EQ(a[k].truth, a[0].truth);
  }
  const auto& points_m = a[0].profiles[1].p_L_m;
  EXPECT_NE(points_m, ScanRound(4, 5, ShapeKind::kTraining)[0].profiles[1].p_L_m);
  EXPECT_NE(points_m, ScanRound(3, 6, ShapeKind::kTraining)[0].profiles[1].p_L_m);
  EXPECT_NE(points_m, ScanRound(3, 5, ShapeKind::kOrdinary)[0].profiles[1].p_L_m);
  EXPECT_NE(points_m, MakeTrainingScans(3, 5, 1)[0].profiles[1].p_L_m);
}

// All views from the head's height above floor or desk, from one distance; each has noise of its
// own and shows another side.
TEST(ScanRound, LooksFromTheHeadsHeightAllRound) {
  int desks = 0, same = 0;
  for (uint64_t t = 0; t < 12; ++t) {
    const auto scans = ScanRound(1, t, ShapeKind::kOrdinary);
    const double height_m = scans[0].camera_position_L_m.z();
    const double support_m = 1.24 - height_m;
    // An attitude believed wrongly does not move the camera.
    EXPECT_LT(std::min(std::abs(support_m), std::abs(support_m - 0.7)), 1e-9);
    desks += support_m > 0.35 ? 1 : 0;
    for (size_t k = 1; k < scans.size(); ++k) {
      EXPECT_NEAR(scans[k].camera_position_L_m.z(), height_m, 1e-12);
      same += scans[k].profiles[1].p_L_m == scans[k - 1].profiles[1].p_L_m ? 1 : 0;
    }
  }
  EXPECT_EQ(same, 0);
  EXPECT_GT(desks, 1);
  EXPECT_LT(desks, 11);
}

TEST(LookRound, KnowsMostOrdinaryShapesFromAllSides) {
  int right = 0, all = 0;
  for (uint64_t t = 0; t < 6; ++t) {
    const ViewRound round = LookRound(1, t, ShapeKind::kOrdinary);
    for (const sensor::GeonVerdict& view : round.views) {
      ++all;
      right += view.label == round.truth ? 1 : 0;
      EXPECT_EQ(view.confidence, view.posterior[static_cast<size_t>(view.label)]);
    }
  }
  EXPECT_GT(right, 9 * all / 10);
}

TEST(FuseLooks, CountsRoundTheTargetBothWays) {
  ViewRound round;
  for (size_t k = 0; k < round.views.size(); ++k) round.views[k].scan_id = static_cast<int>(k);
  const auto last_of = [&round](int look) {
    return FuseLooks(round, std::array{0, look}, {1.0, 0.9}).scan_id;
  };
  EXPECT_EQ(last_of(3), 3);
  EXPECT_EQ(last_of(-1), 11);
  EXPECT_EQ(last_of(13), 1);
  EXPECT_EQ(last_of(-13), 11);
}

}  // namespace
}  // namespace geon::evaluation
