#include <gtest/gtest.h>

#include <string>

#include "base/angles.h"
#include "base/contracts.h"
#include "base/geon_label.h"
#include "base/median.h"
#include "base/plain_name.h"
#include "base/status.h"
#include "base/time.h"

namespace geon {
namespace {

TEST(StatusTest, ErrorKeepsItsWordsAndGainsItsPlace) {
  const Status status = Status::Error("no such key").In("robot.yaml:3");
  EXPECT_FALSE(status.ok());
  EXPECT_EQ(status.message(), "robot.yaml:3: no such key");
  EXPECT_TRUE(Status::Ok().In("anywhere").ok());
}

TEST(ResultTest, ValueOfAnErrorIsABrokenContract) {
  const Result<int> bad = Status::Error("line is dead");
  EXPECT_FALSE(bad.ok());
  EXPECT_THROW(bad.value(), ContractViolation);
  EXPECT_THROW(Result<int>(Status::Ok()), ContractViolation);
}

TEST(ResultTest, MovesItsValueOut) {
  Result<std::string> good = std::string("abc");
  EXPECT_EQ(*good, "abc");
  EXPECT_EQ(std::move(good).value(), "abc");
}

TEST(ContractsTest, ABrokenRuleNamesTheNumberThatBrokeIt) {
  EXPECT_NO_THROW(Require(true, "gap", 3, "must not be negative"));
  try {
    Require(false, "gap", -1, "must not be negative");
    FAIL() << "did not throw";
  } catch (const ContractViolation& violation) {
    EXPECT_STREQ(violation.what(), "gap is -1, must not be negative");
  }
}

TEST(AnglesTest, WrapStaysWithinHalfATurn) {
  EXPECT_NEAR(WrapAngle(3.0 * kPi + 0.1), -kPi + 0.1, 1e-12);
  EXPECT_NEAR(WrapAngle(-2.5 * kPi), -0.5 * kPi, 1e-12);
  EXPECT_DOUBLE_EQ(DegreesFromRadians(RadiansFromDegrees(22.5)), 22.5);
}

TEST(TimeTest, RoundsToTheNearestMicrosecond) {
  EXPECT_EQ(MicrosecondsFromSeconds(0.3), 300000);
  EXPECT_EQ(MicrosecondsFromSeconds(-0.0000016), -2);
  EXPECT_DOUBLE_EQ(SecondsFromMicroseconds(1500000), 1.5);
}

TEST(MedianTest, IsTheMiddleOneOrTheUpperOfTwo) {
  EXPECT_EQ(Median({5.0, -1.0, 3.0}), 3.0);
  EXPECT_EQ(Median({4.0, 1.0, 2.0, 3.0}), 3.0);
  EXPECT_EQ(Median({}), 0.0);
}

TEST(GeonLabelTest, NamesGoThereAndBack) {
  for (int i = 0; i < kGeonLabelCount; ++i) {
    const auto label = static_cast<GeonLabel>(i);
    EXPECT_EQ(GeonLabelFromString(ToString(label)), label);
  }
  EXPECT_FALSE(GeonLabelFromString("sphere").has_value());
  EXPECT_EQ(PlainName(GeonLabel::kTaperedCylinder), "tapered cylinder");
}

}  // namespace
}  // namespace geon
