#include "procs/recognizer/scan_assembler.h"

#include <gtest/gtest.h>

#include <map>

#include "messaging/codec.h"
#include "tests/procs/recognizer/board_scene.h"

namespace geon::recognizer {
namespace {

using sensor::ProfileStatus;

class ScanAssemblerTest : public testing::Test {
 protected:
  ScanAssemblerTest() : plan_(TestPlan(7)) {}

  static const RecognizerConfig& Config() {
    static const RecognizerConfig config = TestConfig();
    return config;
  }
  static const StripeCalibration& Calibration() {
    static const StripeCalibration calibration = TestCalibration(Config().rig);
    return calibration;
  }
  static ScanAssembler NewAssembler() { return {Config().rig, Calibration(), Config().assembler}; }
  sensor::Stripe Stripe(int32_t k, int32_t attempt = 0) const {
    return TestStripe(Config().rig, plan_, k, attempt);
  }
  sensor::Stripe DarkStripe(int32_t k, int32_t attempt = 0) const {
    sensor::Stripe stripe = Stripe(k, attempt);
    stripe.status = sensor::StripeStatus::kNotLit;
    return stripe;
  }
  sensor::ScanCommand End() const {
    sensor::ScanCommand command;
    command.scan_id = plan_.scan_id;
    command.laser = sensor::Laser::kNone;
    return command;
  }

  sensor::ScanPlan plan_;
  ScanAssembler assembler_ = NewAssembler();
};

TEST_F(ScanAssemblerTest, MeasuresABoardWhereItStands) {
  assembler_.Take(plan_);
  const auto answer = assembler_.Take(Stripe(1));
  EXPECT_EQ(answer.profile.status, ProfileStatus::kOk);
  EXPECT_GT(answer.profile.on_target, 150);
  EXPECT_EQ(answer.profile.fraction, 0.5);
  EXPECT_EQ(answer.profile.utime, Stripe(1).utime);
  const sensor::ScanSet scan = assembler_.CurrentScan();
  ASSERT_EQ(scan.profiles.size(), 1U);
  const Eigen::Matrix3d R_BL = scan.profiles[0].rotation_LB->transpose();
  for (const Eigen::Vector3d& p_L : scan.profiles[0].p_L_m) {
    EXPECT_NEAR((R_BL * (p_L - scan.camera_position_L_m)).z(), 1.2, 0.005);
  }
}

TEST_F(ScanAssemblerTest, MeasuresByTheRigWhereThereAreNoTables) {
  ScanAssembler by_rig(Config().rig, std::nullopt, Config().assembler);
  by_rig.Take(plan_);
  assembler_.Take(plan_);
  const auto answer = by_rig.Take(Stripe(4)), by_table = assembler_.Take(Stripe(4));
  EXPECT_EQ(answer.profile.status, ProfileStatus::kOk);
  ASSERT_EQ(answer.profile.pixel, by_table.profile.pixel);
  for (size_t k = 0; k < answer.profile.p_L_m.size(); ++k) {
    EXPECT_NEAR((answer.profile.p_L_m[k] - by_table.profile.p_L_m[k]).norm(), 0.0, 0.002);
  }
}

TEST_F(ScanAssemblerTest, OfSweptStripesTheNearestToEachQuarterCounts) {
  plan_.target_box = {220, 227, 200, 200};  // where the colour camera sees the board
  assembler_.Take(plan_);
  std::map<int32_t, double> nearest_1;
  for (int step = -8; step <= 8; ++step) {
    sensor::Stripe stripe = Stripe(1);
    stripe.stripe_index = stripe.attempt = sensor::kSweptStripe;
    stripe.tilt_rad = 0.01 * step;
    stripe.utime += 100 * step;
    const auto answer = assembler_.Take(stripe);
    EXPECT_FALSE(answer.verdict.has_value());
    if (answer.profile.status != ProfileStatus::kOk) continue;
    const double quarter_1 = 0.25 * (answer.profile.stripe_index + 1);
    const double off_1 = std::abs(answer.profile.fraction - quarter_1);
    for (const double other_1 : {0.25, 0.5, 0.75}) {
      EXPECT_LE(off_1, std::abs(answer.profile.fraction - other_1));
    }
    const auto known = nearest_1.emplace(answer.profile.stripe_index, off_1).first;
    known->second = std::min(known->second, off_1);
  }
  ASSERT_EQ(nearest_1.size(), 3U);
  const sensor::ScanSet scan = assembler_.CurrentScan();
  ASSERT_EQ(scan.profiles.size(), 3U);
  for (const sensor::RangeProfile& profile : scan.profiles) {
    const double quarter_1 = 0.25 * (profile.stripe_index + 1);
    EXPECT_EQ(std::abs(profile.fraction - quarter_1), nearest_1[profile.stripe_index]);
    EXPECT_LT(nearest_1[profile.stripe_index], 0.05);
  }
  // One that the head stopped for is better than any.
  assembler_.Take(Stripe(1));
  EXPECT_EQ(assembler_.CurrentScan().profiles[1].fraction, 0.5);
  EXPECT_TRUE(assembler_.Take(End()).has_value());
}

TEST_F(ScanAssemblerTest, TagsPointsByTheMaskOfTheSameScanWheneverItComes) {
  assembler_.Take(plan_);
  assembler_.Take(Stripe(1));
  EXPECT_TRUE(assembler_.CurrentScan().profiles[0].on_color_1.empty());
  sensor::TargetMask mask;
  mask.scan_id = plan_.scan_id;
  mask.pan_rad = plan_.pan_rad;
  mask.tilt_rad = plan_.tilt_rad;
  mask.box = {0, 0, 640, 480};  // the colour camera shows the board beside the plan's box
  mask.runs_px.push_back(0);
  for (int v = 0; v < mask.box.h_px; ++v) {
    mask.runs_px.push_back(static_cast<int16_t>(mask.box.w_px));
    mask.runs_px.push_back(0);
  }
  mask.scan_id = plan_.scan_id + 1;
  assembler_.Take(mask);
  EXPECT_TRUE(assembler_.CurrentScan().profiles[0].on_color_1.empty());
  mask.scan_id = plan_.scan_id;
  assembler_.Take(mask);
  const sensor::ScanSet scan = assembler_.CurrentScan();
  ASSERT_EQ(scan.profiles[0].on_color_1.size(), scan.profiles[0].p_L_m.size());
  EXPECT_EQ(scan.profiles[0].on_color_1[scan.profiles[0].p_L_m.size() / 2], 1.0);
  mask.box.u_px = -1;  // of another camera: as if it had not come
  mask.scan_id = plan_.scan_id + 1;
  assembler_.Take(mask);
  EXPECT_FALSE(assembler_.CurrentScan().profiles[0].on_color_1.empty());
}

TEST_F(ScanAssemblerTest, GivesTheVerdictWithTheLastStripeAndItsTime) {
  assembler_.Take(plan_);
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(assembler_.Take(Stripe(k)).verdict.has_value());
  const auto answer = assembler_.Take(Stripe(5));
  ASSERT_TRUE(answer.verdict.has_value());
  EXPECT_EQ(answer.verdict->scan_id, 7);
  EXPECT_EQ(answer.verdict->utime, Stripe(5).utime);
  EXPECT_EQ(answer.verdict->profiles.size(), 6U);
  EXPECT_EQ(answer.verdict->method, "evidence");
  EXPECT_FALSE(answer.verdict->reasons.empty());
}

TEST_F(ScanAssemblerTest, TheOrderOfTheStripesDoesNotMatter) {
  assembler_.Take(plan_);
  std::optional<sensor::GeonVerdict> in_order;
  for (int k = 0; k < 6; ++k) in_order = assembler_.Take(Stripe(k)).verdict;
  ScanAssembler other = NewAssembler();
  other.Take(plan_);
  std::optional<sensor::GeonVerdict> shuffled;
  for (const int k : {3, 5, 0, 2, 4, 1}) shuffled = other.Take(Stripe(k)).verdict;
  ASSERT_TRUE(in_order && shuffled);
  EXPECT_EQ(messaging::Encode(*in_order), messaging::Encode(*shuffled));
}

TEST_F(ScanAssemblerTest, AnswersDuplicatesFromMemoryAndRepeatsTheVerdict) {
  assembler_.Take(plan_);
  for (int k = 0; k < 5; ++k) assembler_.Take(Stripe(k));
  const auto last = assembler_.Take(Stripe(5));
  const auto again = assembler_.Take(Stripe(5));
  ASSERT_TRUE(last.verdict && again.verdict);
  EXPECT_EQ(messaging::Encode(last.profile), messaging::Encode(again.profile));
  EXPECT_EQ(messaging::Encode(*last.verdict), messaging::Encode(*again.verdict));
  const auto at_the_end = assembler_.Take(End());
  ASSERT_TRUE(at_the_end.has_value());
  EXPECT_EQ(messaging::Encode(*last.verdict), messaging::Encode(*at_the_end));
}

TEST_F(ScanAssemblerTest, APlanHeardAgainChangesNothing) {
  assembler_.Take(plan_);
  assembler_.Take(Stripe(0));
  plan_.utime += 1'000'000;
  plan_.seq += 1;
  assembler_.Take(plan_);
  EXPECT_EQ(assembler_.good_stripes(), 1);
}

TEST_F(ScanAssemblerTest, ANewOrChangedPlanStartsANewScan) {
  assembler_.Take(plan_);
  assembler_.Take(Stripe(0));
  plan_.support_height_m = 0.7;
  assembler_.Take(plan_);
  EXPECT_EQ(assembler_.good_stripes(), 0);
  assembler_.Take(Stripe(0));
  assembler_.Take(TestPlan(8));
  EXPECT_EQ(assembler_.good_stripes(), 0);
  EXPECT_EQ(assembler_.Take(Stripe(1)).profile.status, ProfileStatus::kRefused);
}

TEST_F(ScanAssemblerTest, StartedInMidScanItRefusesUntilItHearsThePlan) {
  const auto answer = assembler_.Take(Stripe(3));
  EXPECT_EQ(answer.profile.status, ProfileStatus::kRefused);
  EXPECT_EQ(answer.profile.scan_id, 7);
  EXPECT_EQ(answer.profile.stripe_index, 3);
  assembler_.Take(plan_);
  EXPECT_EQ(assembler_.Take(Stripe(3)).profile.status, ProfileStatus::kOk);
}

TEST_F(ScanAssemblerTest, AMissingStripeIsToldAndItsRetryCounts) {
  assembler_.Take(plan_);
  EXPECT_EQ(assembler_.Take(DarkStripe(0)).profile.status, ProfileStatus::kMissing);
  EXPECT_EQ(assembler_.good_stripes(), 0);
  const auto retry = assembler_.Take(Stripe(0, 1));
  EXPECT_EQ(retry.profile.status, ProfileStatus::kOk);
  EXPECT_EQ(retry.profile.attempt, 1);
  EXPECT_EQ(assembler_.good_stripes(), 1);
}

TEST_F(ScanAssemblerTest, OfSeveralGoodAttemptsTheLatestCounts) {
  assembler_.Take(plan_);
  assembler_.Take(Stripe(0, 1));
  assembler_.Take(Stripe(0, 0));  // late
  ASSERT_EQ(assembler_.CurrentScan().profiles.size(), 1U);
  EXPECT_EQ(assembler_.CurrentScan().profiles[0].attempt, 1);
}

TEST_F(ScanAssemblerTest, WithALostStripeTheVerdictComesWhenThePlannerEndsTheScan) {
  assembler_.Take(plan_);
  for (const int k : {0, 1, 3, 4, 5}) EXPECT_FALSE(assembler_.Take(Stripe(k)).verdict.has_value());
  const auto verdict = assembler_.Take(End());
  ASSERT_TRUE(verdict.has_value());
  EXPECT_EQ(verdict->profiles.size(), 5U);
}

TEST_F(ScanAssemblerTest, AnEndWithoutStripesOrOfAnotherScanGivesNothing) {
  EXPECT_FALSE(assembler_.Take(End()).has_value());
  assembler_.Take(plan_);
  EXPECT_FALSE(assembler_.Take(End()).has_value());
  assembler_.Take(Stripe(0));
  sensor::ScanCommand other = End();
  other.scan_id = 99;
  EXPECT_FALSE(assembler_.Take(other).has_value());
  sensor::ScanCommand more = End();
  more.laser = sensor::Laser::kVertical;
  EXPECT_FALSE(assembler_.Take(more).has_value());
}

TEST_F(ScanAssemblerTest, RefusesWhatNoPlanAskedFor) {
  assembler_.Take(plan_);
  sensor::Stripe outside = Stripe(0);
  outside.stripe_index = 6;
  EXPECT_EQ(assembler_.Take(outside).profile.status, ProfileStatus::kRefused);
  sensor::Stripe wrong_laser = Stripe(0);
  wrong_laser.laser = sensor::Laser::kVertical;
  EXPECT_EQ(assembler_.Take(wrong_laser).profile.status, ProfileStatus::kRefused);
  sensor::Stripe wrong_size = Stripe(0);
  wrong_size.difference.width_px = 320;
  EXPECT_EQ(assembler_.Take(wrong_size).profile.status, ProfileStatus::kRefused);
  sensor::Stripe broken = Stripe(1);
  broken.status = sensor::StripeStatus::kMoving;
  EXPECT_EQ(assembler_.Take(broken).profile.status, ProfileStatus::kRefused);
}

}  // namespace
}  // namespace geon::recognizer
