#include "geons/geon_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::geons {
namespace {

TEST(GeonShapeTest, TaperBelongsToTaperedGeonsOnly) {
  GeonShape shape{GeonLabel::kTaperedCuboid, {0.2, 0.2, 0.3}, 0.4, 0.0, 1};
  EXPECT_TRUE(Validate(shape).ok());
  shape.taper_1 = 0.0;
  EXPECT_THAT(Validate(shape).message(), ::testing::HasSubstr("taper"));
  shape = {GeonLabel::kCuboid, {0.2, 0.2, 0.3}, 0.4, 0.0, 1};
  EXPECT_THAT(Validate(shape).message(), ::testing::HasSubstr("no taper"));
}

TEST(GeonShapeTest, BendThatCutsItselfIsRefused) {
  GeonShape shape{GeonLabel::kBentCylinder, {0.08, 0.08, 0.3}, 0.0, kPi, 2};
  EXPECT_TRUE(Validate(shape).ok());
  shape.size_m.x() = 0.2;
  EXPECT_THAT(Validate(shape).message(), ::testing::HasSubstr("cut itself"));
}

TEST(GeonShapeTest, PositionsAreThoseOfTheTables) {
  GeonShape shape{GeonLabel::kBentCylinder, {0.08, 0.08, 0.3}, 0.0, 2.0, 3};
  EXPECT_THAT(Validate(shape).message(), ::testing::HasSubstr("1 to 2"));
  shape.label = GeonLabel::kBentCuboid;
  EXPECT_TRUE(Validate(shape).ok());
  shape.size_m.y() = -1.0;
  EXPECT_THAT(Validate(shape).message(), ::testing::HasSubstr("positive"));
}

}  // namespace
}  // namespace geon::geons
