#include "recognition/recognize_geon.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

TEST(RecognizeGeon, NamesPlainViewsOfAllSevenGeons) {
  for (const geons::GeonShape& shape : PlainGeons()) {
    const auto scan = ScanOfGeon(shape, 0.3, {}, 1);
    ASSERT_TRUE(scan.has_value()) << ToString(shape.label);
    const auto verdict = RecognizeGeon(*scan, {});
    EXPECT_EQ(ToString(verdict.label), ToString(shape.label));
    EXPECT_TRUE(verdict.decided);
    EXPECT_EQ(verdict.profiles.size(), 6U);
  }
}

// The rates measured with many more shapes and views stand in recognize_geon.h; this holds the
// line.
TEST(RecognizeGeon, IsMostlyRightOnRandomShapesAndViews) {
  int right = 0;
  int scans = 0;
  for (const RandomScan& random : RandomScans(3, 77)) {
    ++scans;
    if (RecognizeGeon(random.scan, {}).label == random.label) ++right;
  }
  EXPECT_EQ(scans, 21);
  EXPECT_GE(right, 13);
}

TEST(RecognizeGeon, GivesTheSameBitsTwice) {
  const auto scan = ScanOfGeon(PlainGeons()[3], 0.3, {}, 2);
  const auto first = RecognizeGeon(*scan, {});
  const auto second = RecognizeGeon(*scan, {});
  EXPECT_EQ(first.label, second.label);
  EXPECT_EQ(first.posterior, second.posterior);
  for (size_t i = 0; i < first.profiles.size(); ++i) {
    EXPECT_EQ(first.profiles[i].theta_rad, second.profiles[i].theta_rad);
    EXPECT_EQ(first.profiles[i].arc_length_m, second.profiles[i].arc_length_m);
  }
}

TEST(RecognizeGeon, NeverLooksAtTheTruth) {
  auto scan = *ScanOfGeon(PlainGeons()[0], 0.3, {}, 3);
  const auto without = RecognizeGeon(scan, {});
  scan.truth = GeonLabel::kBentCylinder;
  EXPECT_EQ(RecognizeGeon(scan, {}).posterior, without.posterior);
}

TEST(RecognizeGeon, EachCurvatureMethodGivesAVerdict) {
  const auto scan = ScanOfGeon(PlainGeons()[2], 0.3, {}, 4);
  RecognitionOptions options;
  for (const auto method :
       {CurvatureMethod::kOGorman, CurvatureMethod::kRamer, CurvatureMethod::kWall}) {
    options.curvature = method;
    int curved = 0;
    for (const auto& profile : RecognizeGeon(*scan, options).profiles) {
      curved += profile.curves > 0 ? 1 : 0;
    }
    EXPECT_GE(curved, 4) << "an ellipsoid's profiles are curved";
  }
}

TEST(RecognizeGeon, WithoutVerticalProfilesItOnlyGuesses) {
  auto scan = *ScanOfGeon(PlainGeons()[0], 0.3, {}, 5);
  scan.profiles.resize(3);
  EXPECT_FALSE(RecognizeGeon(scan, {}).decided);
}

TEST(RecognizeGeon, AnEmptyScanIsNotDecided) {
  const auto verdict = RecognizeGeon({}, {});
  EXPECT_FALSE(verdict.decided);
  EXPECT_FALSE(verdict.reasons.empty());
}

TEST(RecognizeGeon, RefusesAProfileWithoutAPixelForEachPoint) {
  auto scan = *ScanOfGeon(PlainGeons()[0], 0.3, {}, 6);
  scan.profiles[0].pixel.pop_back();
  EXPECT_THROW(RecognizeGeon(scan, {}), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
