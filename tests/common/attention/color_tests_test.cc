#include "attention/color_tests.h"

#include <gtest/gtest.h>

namespace geon::attention {
namespace {

HalfSpaceColor ThesisLab() { return NamedColorModel("thesis-lab")->target[0]; }

TEST(ColorTestsTest, HalfSpacesOfOneChannelBecomeBounds) {
  const RegionTest test = TestOf(ThesisLab());
  EXPECT_TRUE(test.bounded);
  EXPECT_EQ(test.low[0], 51);    // (4.12) r > 50
  EXPECT_EQ(test.high[1], 114);  // (4.15) g < 115
  EXPECT_EQ(test.high[2], 74);   // (4.11) b < 75
  EXPECT_EQ(test.high[0], 255);
  EXPECT_EQ(test.planes.size(), 5U);
}

TEST(ColorTestsTest, WholeNumbersLeaveNoDoubt) {
  const RegionTest test = TestOf({{WholeNumbered({0.71, -0.3, -0.44, 12.3}), {1, -1, -1, 20}}});
  EXPECT_FALSE(test.doubtful);
  EXPECT_FALSE(test.bounded);
}

TEST(ColorTestsTest, PrintedSlopesFindSmallEquivalents) {
  // (4.13): 1.333 is as good as 4 / 3 here.
  const PlaneTest slope = TestOf({{{0.0, 1.333, -1.0, -10.0}}}).planes[0];
  EXPECT_EQ(slope.sure, slope.maybe);
  // (4.24): 0.44 is 11 / 25; only where 11 r = 25 g + 1265 the rule's own rounding decides.
  const PlaneTest tie = TestOf({{{-0.44, 1.0, 0.0, -50.6}}}).planes[0];
  EXPECT_EQ(tie.sure - tie.maybe, 1);
}

TEST(ColorTestsTest, AnyOtherPlaneHasANarrowDoubt) {
  const RegionTest test = TestOf({{{1.0 / 3, -1.0 / 7, -0.1234, 1.5}}});
  ASSERT_TRUE(test.doubtful);
  const PlaneTest& plane = test.planes[0];
  EXPECT_LT(plane.sure - plane.maybe, 3 * 128) << "half a coefficient of each channel at most";
}

TEST(ColorTestsTest, EmptyIntervalHoldsNothing) {
  const RegionTest test = TestOf({{{1, 0, 0, 100}, {-1, 0, 0, -50}}});
  EXPECT_GT(test.low[0], test.high[0]);
  const RegionTest none = TestOf({{{1, 0, 0, 300}}});
  EXPECT_GT(none.low[0], none.high[0]);
}

}  // namespace
}  // namespace geon::attention
