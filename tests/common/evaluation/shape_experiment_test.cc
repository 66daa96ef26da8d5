#include "evaluation/shape_experiment.h"

#include <gtest/gtest.h>

#include "geons/polygon_geon.h"

namespace geon::evaluation {
namespace {

TEST(MakeTrialScan, DependsOnSeedAndTrialAlone) {
  const ObjectTracer box(geons::PolygonGeon({GeonLabel::kCuboid, {0.1, 0.12, 0.14}}, 48));
  const ViewingCell cell = ViewingSphere()[3];
  SphereConditions conditions;
  const auto points = [&](int t) {
    return MakeTrialScan(box, cell, t, conditions).profiles[1].p_L_m;
  };
  const auto third = points(3);
  EXPECT_NE(points(4), third);
  EXPECT_EQ(points(3), third);
  conditions.seed = 2;
  EXPECT_NE(points(3), third);
}

TEST(MakeTrialScan, LooksFromTheCellAndTheRangeAskedFor) {
  const ObjectTracer box(geons::PolygonGeon({GeonLabel::kCuboid, {0.1, 0.12, 0.14}}, 48));
  SphereConditions conditions;
  conditions.range_m = 1.6;
  conditions.floor = true;
  const ViewingCell cell{0.6, 0.1};
  const auto scan = MakeTrialScan(box, cell, 0, conditions);
  EXPECT_NEAR(scan.camera_position_L_m.z(), 0.07 + 1.6 * std::sin(0.6), 1e-9);
}

}  // namespace
}  // namespace geon::evaluation
