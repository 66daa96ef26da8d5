#include "recognition/recognition_options.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

TEST(RecognitionOptions, TheDefaultsAreValid) { EXPECT_NO_THROW(RecognitionOptions().Validate()); }

TEST(RecognitionOptions, NeedMoreSamplesThanAThetaPlotSpans) {
  RecognitionOptions options;
  options.samples = 2 * options.difference_of_slope.window + options.difference_of_slope.gap;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

TEST(RecognitionOptions, CheckTheirParts) {
  RecognitionOptions options;
  options.segments.split_m = 0.0;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

TEST(RecognitionOptions, KnowTheNamesPeopleWrite) {
  EXPECT_EQ(MethodFromString("thesis"), Method::kThesis);
  EXPECT_EQ(MethodFromString("evidence"), Method::kEvidence);
  EXPECT_FALSE(MethodFromString("magic").has_value());
  EXPECT_EQ(CurvatureMethodFromString("ogorman"), CurvatureMethod::kOGorman);
  EXPECT_EQ(CurvatureMethodFromString("ramer"), CurvatureMethod::kRamer);
  EXPECT_EQ(CurvatureMethodFromString("wall"), CurvatureMethod::kWall);
  EXPECT_FALSE(CurvatureMethodFromString("Ramer").has_value());
  EXPECT_EQ(SmoothingFromString("median"), Smoothing::kMedian);
  EXPECT_EQ(SmoothingFromString("gaussian"), Smoothing::kGaussian);
  EXPECT_EQ(SmoothingFromString("none"), Smoothing::kNone);
  EXPECT_FALSE(SmoothingFromString("").has_value());
}

}  // namespace
}  // namespace geon::recognition
