#include "recognition/recognize_geon.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

RecognitionOptions ByMethod(Method method) {
  RecognitionOptions options;
  options.method = method;
  return options;
}

double RightOnRandomScans(Method method) {
  double right = 0.0, scans = 0.0;
  for (const RandomScan& random : RandomScans(3, 77)) {
    scans += 1.0;
    if (RecognizeGeon(random.scan, ByMethod(method)).label == random.label) right += 1.0;
  }
  return right / scans;
}

TEST(RecognizeGeon, NamesPlainViewsOfAllSevenGeons) {
  for (const geons::GeonShape& shape : PlainGeons()) {
    const auto scan = ScanOfGeon(shape, 0.3, {}, 1);
    ASSERT_TRUE(scan.has_value()) << ToString(shape.label);
    for (const Method method : {Method::kThesis, Method::kEvidence}) {
      const auto verdict = RecognizeGeon(*scan, ByMethod(method));
      EXPECT_EQ(ToString(verdict.label), ToString(shape.label)) << ToString(method);
      EXPECT_EQ(verdict.method, ToString(method));
      EXPECT_EQ(verdict.profiles.size(), 6U);
      EXPECT_FALSE(verdict.reasons.empty());
    }
    EXPECT_TRUE(RecognizeGeon(*scan, ByMethod(Method::kThesis)).decided);
  }
}

// The rates measured with many more shapes and views stand in docs/experiments.md; this holds the
// line.
TEST(RecognizeGeon, IsMostlyRightOnRandomShapesAndViews) {
  EXPECT_GE(RightOnRandomScans(Method::kThesis), 0.6);
  EXPECT_GE(RightOnRandomScans(Method::kEvidence), 0.8);
}

TEST(RecognizeGeon, PosteriorOfEitherMethodSumsToOne) {
  const auto scan = ScanOfGeon(PlainGeons()[1], 0.3, {}, 8);
  for (const Method method : {Method::kThesis, Method::kEvidence}) {
    double sum = 0.0;
    for (double p : RecognizeGeon(*scan, ByMethod(method)).posterior) sum += p;
    EXPECT_NEAR(sum, 1.0, 1e-9);
  }
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
