#include "procs/geon/recorded_scans.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "messaging/channels.h"
#include "tests/procs/geon/log_file.h"
#include "tests/procs/recognizer/board_scene.h"

namespace geon::cli {
namespace {

using recognizer::ScanAssembler;

// A log of one scan with its verdict, made by the recognizer's own logic.
class RecordedScansTest : public testing::Test {
 protected:
  RecordedScansTest()
      : file_(std::filesystem::path(testing::TempDir()) /
              (std::string("geon_recorded_scans_") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + ".lcmlog")) {}
  ~RecordedScansTest() override { std::filesystem::remove(file_); }

  static const recognizer::RecognizerConfig& Config() {
    static const recognizer::RecognizerConfig config = recognizer::TestConfig();
    return config;
  }
  static const recognizer::StripeCalibration& Calibration() {
    static const recognizer::StripeCalibration calibration =
        recognizer::TestCalibration(Config().rig);
    return calibration;
  }
  static sensor::Session Session(int64_t start_utime) {
    sensor::Session session;
    session.process = "geon-recognizer";
    session.start_utime = start_utime;
    session.calibration_hash = Calibration().hash;
    return session;
  }

  // The messages of a whole scan; `change` may alter the verdict before it is written.
  static void WriteScan(LogFile* log, int64_t scan_id,
                        const std::function<void(sensor::GeonVerdict*)>& change = {}) {
    ScanAssembler assembler(Config().rig, Calibration(), Config().assembler);
    const sensor::ScanPlan plan = recognizer::TestPlan(scan_id);
    assembler.Take(plan);
    log->Write(messaging::kScanPlan, plan);
    for (int32_t k = 0; k < 6; ++k) {
      const sensor::Stripe stripe = recognizer::TestStripe(Config().rig, plan, k);
      log->Write(messaging::kStripe, stripe);
      auto answer = assembler.Take(stripe);
      log->Write(messaging::kRangeProfile, answer.profile);
      if (!answer.verdict) continue;
      answer.verdict->seq = 5;
      if (change) change(&*answer.verdict);
      log->Write(messaging::kGeonVerdict, *answer.verdict);
    }
  }

  ReplayedLog Replay() const {
    auto log = ReplayLog(file_, Config(), Calibration(), [](double) {});
    EXPECT_TRUE(log.ok()) << log.message();
    return std::move(log).value();
  }

  std::filesystem::path file_;
};

TEST_F(RecordedScansTest, ReproducesTheVerdictBitForBit) {
  {
    LogFile log(file_);
    log.Write(messaging::kGeonSession, Session(1));
    WriteScan(&log, 3);
  }
  const ReplayedLog log = Replay();
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_TRUE(log.scans.at(3).identical);
  EXPECT_EQ(log.scans.at(3).good_stripes, 6);
  EXPECT_TRUE(log.identical());
  EXPECT_FALSE(log.damage.any());
  EXPECT_EQ(log.recorded_calibration, Calibration().hash);
}

TEST_F(RecordedScansTest, NoticesEvidenceThatDiffersInTheLastBit) {
  {
    LogFile log(file_);
    WriteScan(&log, 3, [](sensor::GeonVerdict* verdict) {
      double& theta_rad = verdict->profiles[2].theta_rad[4];
      theta_rad = std::nextafter(theta_rad, 10.0);
    });
  }
  EXPECT_FALSE(Replay().identical());
}

TEST_F(RecordedScansTest, UsesWhatIsWholeOfATruncatedLog) {
  {
    LogFile log(file_);
    WriteScan(&log, 3);
    WriteScan(&log, 4);
  }
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) * 3 / 4);
  const ReplayedLog log = Replay();
  EXPECT_TRUE(log.damage.any());
  EXPECT_TRUE(log.scans.at(3).identical);
  EXPECT_FALSE(log.scans.at(4).replayed.has_value());
  EXPECT_FALSE(log.scans.at(4).recorded.has_value());
  EXPECT_LT(log.scans.at(4).good_stripes, 6);
  EXPECT_TRUE(log.identical());
}

TEST_F(RecordedScansTest, AVerdictWhoseStripesAreNotInTheLogIsNotReproduced) {
  {
    LogFile log(file_);
    sensor::GeonVerdict verdict;
    verdict.scan_id = 9;
    log.Write(messaging::kGeonVerdict, verdict);
  }
  const ReplayedLog log = Replay();
  EXPECT_FALSE(log.identical());
  EXPECT_EQ(log.scans.at(9).planned_stripes, 0);
}

TEST_F(RecordedScansTest, ForgetsWhatARecognizerThatStartedAnewForgot) {
  const sensor::ScanPlan plan = recognizer::TestPlan(3);
  {
    LogFile log(file_);
    log.Write(messaging::kGeonSession, Session(1));
    log.Write(messaging::kScanPlan, plan);
    for (int32_t k = 0; k < 3; ++k) {
      log.Write(messaging::kStripe, recognizer::TestStripe(Config().rig, plan, k));
    }
    log.Write(messaging::kGeonSession, Session(2));
    log.Write(messaging::kScanPlan, plan);
    for (int32_t k = 3; k < 6; ++k) {
      log.Write(messaging::kStripe, recognizer::TestStripe(Config().rig, plan, k));
    }
  }
  EXPECT_FALSE(Replay().scans.at(3).replayed.has_value());
}

TEST_F(RecordedScansTest, CountsMessagesThatDoNotDecode) {
  {
    LogFile log(file_);
    log.WriteBytes(messaging::kStripe, {1, 2, 3});
    WriteScan(&log, 3);
  }
  EXPECT_EQ(Replay().unreadable, 1);
  EXPECT_TRUE(Replay().identical());
}

}  // namespace
}  // namespace geon::cli
