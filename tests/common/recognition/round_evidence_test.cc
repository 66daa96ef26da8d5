#include "recognition/round_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recognition/measure_evidence.h"
#include "tests/common/recognition/evidence_of.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

double Measured(GeonLabel label, const char* name) {
  for (const geons::GeonShape& shape : PlainGeons()) {
    if (shape.label == label) {
      return ValueOf(MeasureScan(*ScanOfGeon(shape, 0.3, {}, 1), {}, true), name);
    }
  }
  return -1.0;
}

TEST(RoundEvidence, ATaperedCylinderGrowsAndACylinderDoesNot) {
  EXPECT_GT(Measured(GeonLabel::kTaperedCylinder, "round.growth"), 0.6);
  EXPECT_LT(Measured(GeonLabel::kCylinder, "round.growth"), 0.3);
  EXPECT_GT(Measured(GeonLabel::kTaperedCylinder, "round.taper_sigmas"), 6.0);
  EXPECT_LT(Measured(GeonLabel::kCylinder, "round.taper_sigmas"), 4.0);
}

TEST(RoundEvidence, OfNothingIsFiniteAndSaysThatNothingFits) {
  EvidenceList evidence(true);
  AddRoundEvidence(std::vector<TargetStripe>(6), CrossingGrid(), 0.1, &evidence);
  EXPECT_EQ(ValueOf(evidence, ".misfit"), 1.0);
  for (float value : evidence.values()) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace geon::recognition
