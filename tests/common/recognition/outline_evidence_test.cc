#include "recognition/outline_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "geometry/rigid_transform.h"
#include "tests/common/recognition/evidence_of.h"

namespace geon::recognition {
namespace {

// Six stripes on a flat panel 1 m before a level camera at height 0.5 m, half_m(k) wide and high.
EvidenceList Describe(double growth_m, double waist_m) {
  const Eigen::Vector3d p_LB_m(0.0, 0.0, 0.5);
  std::vector<TargetStripe> stripes(6);
  for (int k = 0; k < 3; ++k) {
    const double half_m = 0.1 + growth_m * (k - 1) - (k == 1 ? waist_m : 0.0);
    const double z_m = 0.5 + 0.05 * (1 - k);
    stripes[static_cast<size_t>(k)].p_L_m = {{1.0, half_m, z_m}, {1.0, -half_m, z_m}};
    const double y_m = 0.05 * (1 - k);
    stripes[static_cast<size_t>(3 + k)].p_L_m = {{1.0, y_m, 0.6}, {1.0, y_m, 0.4}};
  }
  EvidenceList evidence(true);
  AddOutlineEvidence(stripes, {p_LB_m, geometry::CameraAxesInBody()}, 0.2, &evidence);
  return evidence;
}

TEST(OutlineEvidence, ABoxHasParallelStraightSides) {
  const EvidenceList box = Describe(0.0, 0.0);
  EXPECT_NEAR(ValueOf(box, "left.concave"), 0.0, 1e-6);
  EXPECT_NEAR(ValueOf(box, "horizontal.grow"), 0.0, 1e-6);
  EXPECT_NEAR(ValueOf(box, "horizontal.convergence"), 0.0, 1e-6);
}

TEST(OutlineEvidence, AConeGrowsFromStripeToStripe) {
  const EvidenceList cone = Describe(0.02, 0.0);
  EXPECT_NEAR(ValueOf(cone, "horizontal.grow_1"), 0.2, 1e-6);
  EXPECT_NEAR(ValueOf(cone, "horizontal.grow"), 0.4, 1e-6);
  EXPECT_NEAR(ValueOf(cone, "horizontal.convergence"), 2.0 * std::atan(0.4), 1e-3);
  EXPECT_NEAR(ValueOf(cone, "left.concave"), 0.0, 1e-6);
}

TEST(OutlineEvidence, AWaistIsConcaveOnBothSides) {
  const EvidenceList waist = Describe(0.0, 0.02);
  EXPECT_NEAR(ValueOf(waist, "left.concave"), 0.1, 1e-6);
  EXPECT_NEAR(ValueOf(waist, "right.concave"), 0.1, 1e-6);
  EXPECT_NEAR(ValueOf(waist, "left.off_chord"), 0.1, 1e-6);
}

TEST(OutlineEvidence, ASideWithoutAStripeGivesAsManyZeros) {
  EvidenceList evidence(true);
  AddOutlineEvidence(std::vector<TargetStripe>(6), BwCamera(), 0.2, &evidence);
  EXPECT_EQ(evidence.values().size(), Describe(0.0, 0.0).values().size());
  for (float value : evidence.values()) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace geon::recognition
