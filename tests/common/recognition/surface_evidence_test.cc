#include "recognition/surface_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "geometry/rigid_transform.h"
#include "tests/common/recognition/evidence_of.h"

namespace geon::recognition {
namespace {

// Six stripes of 20 cm on a surface about 1 m before a level camera, that stands out towards it by
// height_m(y, z - 0.5).
EvidenceList Describe(const std::function<double(double, double)>& height_m) {
  const Eigen::Vector3d p_LB_m(0.0, 0.0, 0.5);
  std::vector<TargetStripe> stripes(6);
  for (int k = 0; k < 3; ++k) {
    const double at_m = 0.05 * (1 - k);
    for (int i = 0; i <= 200; ++i) {
      const double along_m = 0.1 - 0.001 * i;  // from left to right, from above to below
      stripes[static_cast<size_t>(k)].p_L_m.emplace_back(1.0 - height_m(along_m, at_m), along_m,
                                                         0.5 + at_m);
      stripes[static_cast<size_t>(3 + k)].p_L_m.emplace_back(1.0 - height_m(at_m, along_m), at_m,
                                                             0.5 + along_m);
    }
  }
  EvidenceList evidence(true);
  AddSurfaceEvidence(stripes, p_LB_m, geometry::CameraAxesInBody(), 0.2, &evidence);
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
  AddSurfaceEvidence(std::vector<TargetStripe>(6), Eigen::Vector3d::Zero(),
                     Eigen::Matrix3d::Identity(), 0.2, &evidence);
  EXPECT_EQ(ValueOf(evidence, ".crossings"), 0.0);
  EXPECT_EQ(evidence.values().size(), Describe([](double, double) { return 0.0; }).values().size());
}

}  // namespace
}  // namespace geon::recognition
