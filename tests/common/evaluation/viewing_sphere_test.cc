#include "evaluation/viewing_sphere.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::evaluation {
namespace {

TEST(ViewingSphere, HasTheThesissHundredAndFortyFourCells) {
  const std::vector<ViewingCell> cells = ViewingSphere();
  ASSERT_EQ(cells.size(), 144U);
  EXPECT_NEAR(cells.front().elevation_rad, RadiansFromDegrees(35), 1e-12);
  EXPECT_NEAR(cells.front().azimuth_rad, RadiansFromDegrees(5), 1e-12);
  EXPECT_NEAR(cells.back().elevation_rad, RadiansFromDegrees(65), 1e-12);
  EXPECT_NEAR(cells.back().azimuth_rad, RadiansFromDegrees(355), 1e-12);
}

TEST(ViewingSphere, TakesOtherElevations) {
  EXPECT_EQ(ViewingSphere(10, 30).size(), 72U);
  EXPECT_NEAR(ViewingSphere(70, 80).front().elevation_rad, RadiansFromDegrees(75), 1e-12);
}

TEST(ViewingSphere, RefusesLimitsBetweenCells) {
  EXPECT_THROW(ViewingSphere(35, 70), ContractViolation);
  EXPECT_THROW(ViewingSphere(30, 30), ContractViolation);
  EXPECT_THROW(ViewingSphere(30, 100), ContractViolation);
}

}  // namespace
}  // namespace geon::evaluation
