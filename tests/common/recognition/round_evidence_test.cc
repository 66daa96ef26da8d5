#include "recognition/round_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recognition/measure_evidence.h"
#include "tests/common/recognition/evidence_of.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

double Growth(GeonLabel label) {
  for (const geons::GeonShape& shape : PlainGeons()) {
    if (shape.label == label) {
      return ValueOf(MeasureScan(*ScanOfGeon(shape, 0.3, {}, 1), {}, true), "round.growth");
    }
  }
  return -1.0;
}

TEST(RoundEvidence, ATaperedCylinderGrowsAndACylinderDoesNot) {
  EXPECT_GT(Growth(GeonLabel::kTaperedCylinder), 0.6);
  EXPECT_LT(Growth(GeonLabel::kCylinder), 0.3);
}

TEST(RoundEvidence, OfNothingIsFiniteAndSaysThatNothingFits) {
  EvidenceList evidence(true);
  AddRoundEvidence(std::vector<TargetStripe>(6), CrossingGrid(), 0.1, &evidence);
  EXPECT_EQ(ValueOf(evidence, ".misfit"), 1.0);
  for (float value : evidence.values()) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace geon::recognition
