#include "active_vision/order_stripes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

using sensor::Laser;
using testing::ElementsAre;

std::vector<sensor::PlannedStripe> Six() {
  return {{Laser::kHorizontal, 0.25, 0.0, -0.15}, {Laser::kHorizontal, 0.5, 0.0, -0.20},
          {Laser::kHorizontal, 0.75, 0.0, -0.25}, {Laser::kVertical, 0.25, 0.05, -0.20},
          {Laser::kVertical, 0.5, 0.0, -0.20},    {Laser::kVertical, 0.75, -0.05, -0.20}};
}

TEST(TurnTimeTest, IsThatOfTheSlowerAxisWithRampsAtBothEnds) {
  const HeadMotion motion{0.9, 1.8};
  // Ramps alone: up for 0.1 s, down for 0.1 s.
  EXPECT_NEAR(TurnTime({0, 0}, {0.018, 0.0}, motion), 0.2, 1e-12);
  // 0.45 rad on the ramps in 1 s, the rest at full speed.
  EXPECT_NEAR(TurnTime({0, 0}, {0.0, 0.45 + 0.9}, motion), 2.0, 1e-12);
  EXPECT_EQ(TurnTime({0, 0}, {0.3, 0.5}, motion), TurnTime({0, 0}, {0.0, -0.5}, motion));
  EXPECT_EQ(TurnTime({0.1, 0.2}, {0.1, 0.2}, motion), 0.0);
}

TEST(OrderStripesTest, BeginsAtTheNearerEnd) {
  EXPECT_EQ(OrderStripes(Six(), {0.0, -0.4})[0], 2U);
  EXPECT_EQ(OrderStripes(Six(), {0.0, 0.1})[0], 0U);
}

TEST(OrderStripesTest, HorizontalOnesComeFirstAndNothingIsLeftOut) {
  const auto order = OrderStripes(Six(), {0.05, -0.4});
  EXPECT_THAT(std::vector<size_t>(order.begin(), order.begin() + 3),
              testing::UnorderedElementsAre(0, 1, 2));
  EXPECT_THAT(std::vector<size_t>(order.begin() + 3, order.end()),
              testing::UnorderedElementsAre(3, 4, 5));
}

TEST(OrderStripesTest, TakesNoLongerThanTheOrderOfThePlan) {
  const auto stripes = Six();
  const auto duration_s = [&](const std::vector<size_t>& order) {
    double sum_s = 0.0;
    HeadAngles at{0.02, -0.3};
    for (const size_t k : order) {
      sum_s += TurnTime(at, {stripes[k].pan_rad, stripes[k].tilt_rad});
      at = {stripes[k].pan_rad, stripes[k].tilt_rad};
    }
    return sum_s;
  };
  EXPECT_LT(duration_s(OrderStripes(stripes, {0.02, -0.3})), duration_s({0, 1, 2, 3, 4, 5}));
}

TEST(OrderStripesTest, AFewStripesAndNoneAreFineButNotFourOfOneLaser) {
  EXPECT_TRUE(OrderStripes({}, {}).empty());
  EXPECT_THAT(OrderStripes({Six()[4]}, {}), ElementsAre(0));
  EXPECT_THROW(OrderStripes(std::vector<sensor::PlannedStripe>(4), {}), ContractViolation);
}

}  // namespace
}  // namespace geon::active_vision
