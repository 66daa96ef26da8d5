#include "recognition/find_tapering.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// HorizontalEnds stripes with these left and right ends.
std::vector<ProfileEnds> HorizontalEnds(const std::array<double, 3>& left_m,
                                        const std::array<double, 3>& right_m) {
  std::vector<ProfileEnds> ends;
  for (size_t i = 0; i < 3; ++i) {
    ProfileEnds e;
    e.first_B_m = {left_m[i], 0.05 * static_cast<double>(i), 1.0};
    e.last_B_m = {right_m[i], 0.05 * static_cast<double>(i), 1.0};
    e.length_m = right_m[i] - left_m[i];
    ends.push_back(e);
  }
  return ends;
}

TEST(FindTapering, LengthsThatRiseOrFallMeanTapering) {
  const auto rising =
      FindTapering(HorizontalEnds({-0.05, -0.06, -0.07}, {0.05, 0.06, 0.07}), {}, {});
  EXPECT_TRUE(rising.monotone_horizontal);
  EXPECT_FALSE(rising.asymmetric_ends);
  EXPECT_TRUE(rising.found());
  EXPECT_TRUE(FindTapering(HorizontalEnds({-0.07, -0.06, -0.05}, {0.07, 0.06, 0.05}), {}, {})
                  .monotone_horizontal);
  EXPECT_TRUE(FindTapering({}, HorizontalEnds({-0.09, -0.06, -0.03}, {0.09, 0.06, 0.03}), {})
                  .monotone_vertical);
}

TEST(FindTapering, LengthsThatAreEqualWithinNoiseDoNot) {
  EXPECT_FALSE(
      FindTapering(HorizontalEnds({-0.05, -0.051, -0.052}, {0.05, 0.05, 0.05}), {}, {}).found());
}

TEST(FindTapering, LengthsThatRiseAndFallDoNot) {
  EXPECT_FALSE(FindTapering(HorizontalEnds({-0.05, -0.08, -0.05}, {0.05, 0.08, 0.05}), {}, {})
                   .monotone_horizontal);
}

TEST(FindTapering, EndsThatStepUnequallyMeanTapering) {
  // (5.8): |0.08 - 0| on the left, 0 on the right.
  const auto tapering = FindTapering(HorizontalEnds({-0.1, -0.02, -0.02}, {0.1, 0.1, 0.1}), {}, {});
  EXPECT_NEAR(tapering.asymmetry_m, 0.08, 1e-12);
  EXPECT_TRUE(tapering.asymmetric_ends);
}

TEST(FindTapering, EndsOfASlantedCuboidStepAlike) {
  const auto tapering =
      FindTapering(HorizontalEnds({-0.1, -0.13, -0.08}, {0.1, 0.15, 0.12}), {}, {});
  EXPECT_NEAR(tapering.asymmetry_m, 0.0, 1e-12);
  EXPECT_FALSE(tapering.asymmetric_ends);
}

TEST(FindTapering, TolerancesGrowWithTheMeanLength) {
  TaperingOptions options;
  const auto ends = HorizontalEnds({-0.05, -0.06, -0.07}, {0.05, 0.06, 0.07});  // mean 0.12 m
  options.horizontal_length = {0.001, 0.1};
  EXPECT_TRUE(FindTapering(ends, {}, options).monotone_horizontal);
  options.horizontal_length.relative_1 = 0.2;
  EXPECT_FALSE(FindTapering(ends, {}, options).monotone_horizontal);
  const auto unequal = HorizontalEnds({-0.1, -0.02, -0.02}, {0.1, 0.1, 0.1});
  options.horizontal_step = {0.01, 0.3};  // 10 + 0.3 * 147 mm
  EXPECT_TRUE(FindTapering(unequal, {}, options).asymmetric_ends);
  options.horizontal_step.relative_1 = 0.6;
  EXPECT_FALSE(FindTapering(unequal, {}, options).asymmetric_ends);
}

TEST(FindTapering, TwoStripesAreNotEnough) {
  auto ends = HorizontalEnds({-0.05, -0.07, -0.09}, {0.05, 0.07, 0.09});
  ends.pop_back();
  EXPECT_FALSE(FindTapering(ends, ends, {}).found());
}

TEST(FindTapering, RefusesANegativeTolerance) {
  TaperingOptions options;
  options.vertical_step.absolute_m = -0.001;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
