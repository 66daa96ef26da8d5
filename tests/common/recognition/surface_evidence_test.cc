#include "recognition/surface_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/common/recognition/evidence_of.h"
#include "tests/common/recognition/surface_view.h"

namespace geon::recognition {
namespace {

EvidenceList Describe(const std::function<double(double, double)>& height_m) {
  EvidenceList evidence(true);
  AddSurfaceEvidence(FindCrossings(ViewOfSurface(height_m)), 0.2, &evidence);
  return evidence;
}

TEST(SurfaceEvidence, APlaneHasOneNormalAndNoCurvature) {
  const EvidenceList plane = Describe([](double, double z_m) { return -0.5 * z_m; });
  EXPECT_EQ(ValueOf(plane, ".crossings"), 9.0);
  EXPECT_NEAR(ValueOf(plane, ".up_11"), 0.5 / std::sqrt(1.25), 1e-3);
  EXPECT_NEAR(ValueOf(plane, ".normals_2"), 0.0, 1e-3);
  EXPECT_NEAR(ValueOf(plane, ".off_plane"), 0.0, 1e-3);
  EXPECT_NEAR(ValueOf(plane, ".along_rows_0"), 0.0, 1e-2);
}

TEST(SurfaceEvidence, ACylinderCurvesOneWayASphereBoth) {
  const auto arc = [](double squared_m2) { return std::sqrt(0.04 - squared_m2); };
  const EvidenceList cylinder = Describe([&](double y_m, double) { return arc(y_m * y_m); });
  const EvidenceList ball =
      Describe([&](double y_m, double z_m) { return arc(y_m * y_m + z_m * z_m); });
  EXPECT_NEAR(ValueOf(cylinder, ".along_rows_rank_2"), 1.0, 0.1);
  EXPECT_NEAR(ValueOf(cylinder, ".along_columns_rank_2"), 0.0, 0.1);
  EXPECT_NEAR(ValueOf(ball, ".along_rows_rank_2"), 1.0, 0.1);
  EXPECT_NEAR(ValueOf(ball, ".along_columns_rank_2"), 1.0, 0.1);
}

TEST(SurfaceEvidence, WithoutCrossingsThereIsNothing) {
  EvidenceList evidence(true);
  AddSurfaceEvidence(CrossingGrid(), 0.2, &evidence);
  EXPECT_EQ(ValueOf(evidence, ".crossings"), 0.0);
  EXPECT_EQ(evidence.values().size(), Describe([](double, double) { return 0.0; }).values().size());
}

}  // namespace
}  // namespace geon::recognition
