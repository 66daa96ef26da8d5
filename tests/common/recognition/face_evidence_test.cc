#include "recognition/face_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/angles.h"
#include "tests/common/recognition/evidence_of.h"
#include "tests/common/recognition/surface_view.h"

namespace geon::recognition {
namespace {

EvidenceList Describe(const TargetView& view) {
  EvidenceList evidence(true);
  AddFaceEvidence(view.stripes, FindCrossings(view), &evidence);
  return evidence;
}

// Two upright faces that meet at an upright edge.
TargetView Ridge(double steepness) {
  return ViewOfSurface([=](double y_m, double) { return -steepness * std::abs(y_m - 0.02); });
}

TEST(FaceEvidence, TheFacesOfARidgeStandAskewUnlessItIsARightAngle) {
  const double skew_rad = kPi / 2 - 2.0 * std::atan(0.5);
  const EvidenceList square = Describe(Ridge(1.0)), askew = Describe(Ridge(0.5));
  EXPECT_NEAR(ValueOf(square, ".skew_max"), 0.0, 0.03);
  EXPECT_NEAR(ValueOf(square, ".upright_skew"), 0.0, 0.03);
  EXPECT_EQ(ValueOf(askew, ".faces"), 2.0);
  EXPECT_NEAR(ValueOf(askew, ".skew_max"), skew_rad, 0.03);
  EXPECT_NEAR(ValueOf(askew, ".upright_skew"), skew_rad, 0.03);
  EXPECT_NEAR(ValueOf(askew, ".lean_max"), 0.0, 0.03) << "both faces are upright";
}

// A plane towards us whose stripes end earlier the higher they are.
TargetView Trapezoid(double narrower_1) {
  TargetView view = ViewOfSurface([](double, double) { return 0.0; });
  for (size_t k = 0; k < 3; ++k) {
    for (Eigen::Vector3d& p_m : view.stripes[k].p_L_m) {
      p_m.y() *= 1.0 - narrower_1 * (2.0 - static_cast<double>(k));
    }
  }
  return view;
}

TEST(FaceEvidence, TheSidesOfATrapezoidStandAskewToItsUpperEdge) {
  EXPECT_NEAR(ValueOf(Describe(Trapezoid(0.0)), ".side_to_edge_0"), 0.0, 1e-6);
  const double lean_rad = std::atan(0.1 * 0.1 / 0.05);
  for (const char* name : {".side_to_edge_0", ".side_to_edge_1"}) {
    EXPECT_NEAR(ValueOf(Describe(Trapezoid(0.1)), name), lean_rad, 1e-6) << name;
  }
  EXPECT_NEAR(ValueOf(Describe(Trapezoid(0.1)), ".edge_to_face_0"), 0.0, 1e-3);
}

TEST(FaceEvidence, OfNothingThereIsAsMuchAndAllOfItZero) {
  EvidenceList evidence(true);
  AddFaceEvidence(std::vector<TargetStripe>(6), CrossingGrid(), &evidence);
  EXPECT_EQ(evidence.values().size(), Describe(Ridge(1.0)).values().size());
  for (float value : evidence.values()) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace geon::recognition
