#include "recognition/measure_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "recognition/geon_forest.h"
#include "recognition/recognize_geon.h"
#include "tests/common/recognition/evidence_of.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

EvidenceList Measure(GeonLabel label) {
  for (const geons::GeonShape& shape : PlainGeons()) {
    if (shape.label == label) return MeasureScan(*ScanOfGeon(shape, 0.3, {}, 1), {}, true);
  }
  throw std::out_of_range("no such geon");
}

TEST(MeasureEvidence, GivesWhatTheForestWantsWhateverTheScan) {
  const auto wanted = static_cast<size_t>(TrainedForest().features);
  for (const geons::GeonShape& shape : PlainGeons()) {
    auto scan = *ScanOfGeon(shape, 0.3, {}, 1);
    EXPECT_EQ(MeasureScan(scan).values().size(), wanted);
    scan.profiles.resize(2);
    EXPECT_EQ(MeasureScan(scan).values().size(), wanted);
  }
  EXPECT_EQ(MeasureScan({}).values().size(), wanted);
}

TEST(MeasureEvidence, IsFiniteEvenOfNothing) {
  for (const EvidenceList& evidence : {MeasureScan({}), Measure(GeonLabel::kBentCuboid)}) {
    for (float value : evidence.values()) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(MeasureEvidence, NamesEachMeasurementOnce) {
  const EvidenceList evidence = Measure(GeonLabel::kCuboid);
  EXPECT_EQ(evidence.names().size(), evidence.values().size());
  EXPECT_EQ(std::set(evidence.names().begin(), evidence.names().end()).size(),
            evidence.names().size());
}

TEST(MeasureEvidence, SeesTheTurningOfARoundSurface) {
  const std::string name = "horizontal_2.fine_50";
  EXPECT_GT(ValueOf(Measure(GeonLabel::kEllipsoid), name), 0.1);
  EXPECT_LT(std::abs(ValueOf(Measure(GeonLabel::kCuboid), name)), 0.1);
}

TEST(MeasureEvidence, SeesLengthsGrow) {
  EXPECT_GT(ValueOf(Measure(GeonLabel::kTaperedCuboid), "horizontal.grow"), 0.05);
  EXPECT_LT(std::abs(ValueOf(Measure(GeonLabel::kCylinder), "horizontal.grow")), 0.05);
}

TEST(MeasureEvidence, SeesThatASphereCurvesBothWays) {
  const EvidenceList ball = Measure(GeonLabel::kEllipsoid), box = Measure(GeonLabel::kCuboid);
  EXPECT_GT(ValueOf(ball, "surface.along_rows_rank_0"), 0.2);
  EXPECT_GT(ValueOf(ball, "surface.along_columns_rank_0"), 0.2);
  EXPECT_GT(ValueOf(ball, "surface.normals_1"), ValueOf(box, "surface.normals_0"));
}

}  // namespace
}  // namespace geon::recognition
