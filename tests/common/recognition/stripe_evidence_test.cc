#include "recognition/stripe_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/common/recognition/evidence_of.h"

namespace geon::recognition {
namespace {

// A horizontal stripe of 20 cm whose surface stands out by height_m(x), x from -0.1 to 0.1.
EvidenceList Describe(const std::function<double(double)>& height_m) {
  TargetStripe stripe;
  stripe.segment_begins = {0};
  for (int k = 0; k <= 200; ++k) {
    const double x_m = 0.001 * k - 0.1;
    stripe.curve_m.emplace_back(x_m, height_m(x_m));
    stripe.p_L_m.emplace_back(1.0 - height_m(x_m), -x_m, 0.1);
  }
  EvidenceList evidence(true);
  AddStripeEvidence(stripe, 0.2, &evidence);
  return evidence;
}

double Arc(double x_m) { return std::sqrt(0.15 * 0.15 - x_m * x_m); }
double Roof(double x_m) { return -std::abs(x_m); }

TEST(StripeEvidence, ALineFitsALine) {
  const EvidenceList flat = Describe([](double x_m) { return 0.3 * x_m; });
  EXPECT_NEAR(ValueOf(flat, ".line"), 0.0, 1e-5);
  EXPECT_NEAR(ValueOf(flat, ".fine_max"), 0.0, 1e-3);
  EXPECT_NEAR(ValueOf(flat, ".rise"), 0.0, 1e-4);
}

TEST(StripeEvidence, AnArcFitsACircleAndNotTwoLines) {
  const EvidenceList arc = Describe(Arc);
  EXPECT_LT(ValueOf(arc, ".circle"), 1e-3);
  EXPECT_GT(ValueOf(arc, ".two_lines"), 5e-3);
  EXPECT_NEAR(ValueOf(arc, ".curvature"), 0.2 / 0.15, 0.05);
  EXPECT_NEAR(ValueOf(arc, ".rise_place"), 0.5, 0.03);
}

TEST(StripeEvidence, ARoofFitsTwoLinesThatMeetInItsMiddle) {
  const EvidenceList roof = Describe(Roof);
  EXPECT_LT(ValueOf(roof, ".two_lines"), 2e-3);
  EXPECT_GT(ValueOf(roof, ".circle"), 1e-2);
  EXPECT_NEAR(ValueOf(roof, ".corner_place"), 0.5, 0.05);
  EXPECT_GT(ValueOf(roof, ".fine_max"), 1.0);
}

TEST(StripeEvidence, AHollowFallsBelowItsChord) {
  const EvidenceList hollow = Describe([](double x_m) { return -Arc(x_m); });
  EXPECT_LT(ValueOf(hollow, ".fall"), -0.1);
  EXPECT_LT(ValueOf(hollow, ".curvature"), -1.0);
}

TEST(StripeEvidence, AnEmptyStripeSaysNothing) {
  EvidenceList evidence(true);
  AddStripeEvidence({}, 0.2, &evidence);
  EXPECT_EQ(ValueOf(evidence, ".segments"), 0.0);
  for (float value : evidence.values()) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace geon::recognition
