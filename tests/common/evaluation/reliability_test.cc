#include "evaluation/reliability.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/contracts.h"

namespace geon::evaluation {
namespace {

std::vector<Prediction> Repeat(int n, int right, double confidence_1) {
  std::vector<Prediction> predictions;
  for (int k = 0; k < n; ++k) predictions.push_back({confidence_1, k < right, true});
  return predictions;
}

TEST(MeasureReliability, NinetyOfAHundredAtNinetyPercentIsNoError) {
  const Reliability result = MeasureReliability(Repeat(100, 90, 0.9));
  EXPECT_NEAR(result.expected_calibration_error_1, 0.0, 1e-12);
  EXPECT_EQ(result.bins[13].rate.n, 100);
  EXPECT_NEAR(result.bins[13].mean_confidence_1, 0.9, 1e-12);
}

TEST(MeasureReliability, WeighsEachBinByItsPredictions) {
  std::vector<Prediction> predictions = Repeat(30, 15, 0.9);                    // 0.4 too sure
  for (const Prediction& one : Repeat(10, 3, 0.1)) predictions.push_back(one);  // 0.2 too modest
  const Reliability result = MeasureReliability(predictions);
  EXPECT_NEAR(result.expected_calibration_error_1, 0.75 * 0.4 + 0.25 * 0.2, 1e-12);
}

TEST(MeasureReliability, ErrorsInOneBinCancelInDifferentBinsAddUp) {
  // 0.91 and 0.97 fall into bins 14 and 15: right one time in one, and none in one.
  const Reliability apart =
      MeasureReliability(std::vector<Prediction>{{0.91, true, true}, {0.97, false, true}});
  EXPECT_NEAR(apart.expected_calibration_error_1, 0.5 * 0.09 + 0.5 * 0.97, 1e-12);
  const Reliability together =
      MeasureReliability(std::vector<Prediction>{{0.51, true, true}, {0.53, false, true}});
  EXPECT_NEAR(together.expected_calibration_error_1, 0.02, 1e-12);
}

TEST(MeasureReliability, BinsAreClosedAbove) {
  const Reliability result =
      MeasureReliability(std::vector<Prediction>{{0.0, false, true},
                                                 {1.0 / 15.0, false, true},
                                                 {1.0 / 15.0 + 1e-9, true, true},
                                                 {1.0, true, true}});
  EXPECT_EQ(result.bins[0].rate.n, 2);
  EXPECT_EQ(result.bins[1].rate.n, 1);
  EXPECT_EQ(result.bins[14].rate.n, 1);
  EXPECT_EQ(result.bins[14].high_1, 1.0);
  EXPECT_EQ(result.bins[7].rate.n, 0);
  EXPECT_EQ(result.bins[7].mean_confidence_1, 0.0);
}

TEST(MeasureReliability, TellsDecidedAnswersFromGuesses) {
  const Reliability result = MeasureReliability(std::vector<Prediction>{
      {0.9, true, true}, {0.8, false, true}, {0.7, true, true}, {0.3, false, false}});
  EXPECT_EQ(result.all.n, 4);
  EXPECT_EQ(result.decided_share().right, 3);
  EXPECT_EQ(result.decided_share().n, 4);
  EXPECT_EQ(result.decided.right, 2);
  EXPECT_EQ(result.undecided.n, 1);
  EXPECT_EQ(result.undecided.right, 0);
}

TEST(MeasureReliability, NothingIsNoErrorAndNoConfidenceIsRefused) {
  EXPECT_EQ(MeasureReliability({}).expected_calibration_error_1, 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double confidence_1 : {-0.1, 1.1, nan}) {
    EXPECT_THROW(MeasureReliability(Repeat(1, 1, confidence_1)), ContractViolation);
  }
}

TEST(PredictionsOf, AreRightWhenTheAnswerIsTheTruth) {
  const std::vector<Subject> subjects = {{GeonLabel::kCuboid, "1", 1}};
  const std::vector<ShapeTrial> trials = {{0, 0, {}, GeonLabel::kCuboid, 0.6, true},
                                          {1, 0, {}, GeonLabel::kEllipsoid, 0.4, false}};
  const std::vector<Prediction> predictions = PredictionsOf(subjects, trials);
  ASSERT_EQ(predictions.size(), 2U);
  EXPECT_TRUE(predictions[0].right);
  EXPECT_EQ(predictions[0].confidence_1, 0.6);
  EXPECT_FALSE(predictions[1].right);
  EXPECT_FALSE(predictions[1].decided);
}

}  // namespace
}  // namespace geon::evaluation
