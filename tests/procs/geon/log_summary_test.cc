#include "procs/geon/log_summary.h"

#include <gtest/gtest.h>
#include <lcm/eventlog.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "messaging/channels.h"
#include "messaging/codec.h"
#include "messaging/message_schema.h"
#include "sensor/health.h"
#include "sensor/ptu.h"

namespace geon::cli {
namespace {

// A log that is written event by event.
class LogSummaryTest : public testing::Test {
 protected:
  LogSummaryTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) /
            (std::string("geon_log_summary_") + info->name() + ".lcmlog");
    log_ = lcm_eventlog_create(file_.c_str(), "w");
  }
  ~LogSummaryTest() override {
    Close();
    std::filesystem::remove(file_);
  }
  void Close() {
    if (log_ != nullptr) lcm_eventlog_destroy(log_);
    log_ = nullptr;
  }
  void Write(std::string channel, std::vector<uint8_t> bytes, int64_t utime) {
    lcm_eventlog_event_t event{};
    event.timestamp = utime;
    event.channellen = static_cast<int32_t>(channel.size());
    event.channel = channel.data();
    event.datalen = static_cast<int32_t>(bytes.size());
    event.data = bytes.data();
    ASSERT_EQ(lcm_eventlog_write_event(log_, &event), 0);
  }
  void WriteHead(int32_t seq, int64_t utime) {
    sensor::PtuState state;
    state.seq = seq;
    Write(std::string(messaging::kPtuState), messaging::Encode(state), utime);
  }
  LogSummary Summarize() {
    Close();
    Result<LogSummary> summary = SummarizeLog(file_);
    EXPECT_TRUE(summary.ok()) << summary.message();
    return summary.ok() ? *summary : LogSummary{};
  }

  std::filesystem::path file_;
  lcm_eventlog_t* log_ = nullptr;
};

TEST_F(LogSummaryTest, CountsRatesGapsAndLosses) {
  WriteHead(1, 1'000'000);
  WriteHead(2, 1'100'000);
  WriteHead(5, 1'600'000);
  sensor::Session session;
  session.seq = 1;
  session.version = "1.2.3";
  session.types_hash = messaging::TypesHash();
  Write(std::string(messaging::kGeonSession), messaging::Encode(session), 2'000'000);
  const LogSummary summary = Summarize();
  EXPECT_EQ(summary.events, 4);
  EXPECT_EQ(summary.SpanSeconds(), 1.0);
  EXPECT_EQ(summary.Lost(), 2);
  EXPECT_EQ(summary.versions, std::set<std::string>{"1.2.3"});
  EXPECT_EQ(summary.foreign_sessions, 0);
  EXPECT_EQ(summary.Complaint(), "");
  const LogChannel& head = summary.channels.at("PTU_STATE");
  EXPECT_EQ(head.type, "ptu_state_t");
  EXPECT_EQ(head.longest_gap_us, 500'000);
  EXPECT_NEAR(head.RateHz(), 2 / 0.6, 1e-9);
  const auto json = ToJson(summary);
  EXPECT_EQ(json["whole"], true);
  EXPECT_EQ(json["channels"].size(), 2u);
  EXPECT_NE(ToText(summary).find("PTU_STATE"), std::string::npos);
}

TEST_F(LogSummaryTest, ATornLogIsNotWhole) {
  WriteHead(1, 1);
  WriteHead(2, 2);
  Close();
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 10);
  const LogSummary summary = Summarize();
  EXPECT_EQ(summary.events, 1);
  EXPECT_NE(summary.Complaint().find("torn"), std::string::npos);
  EXPECT_EQ(ToJson(summary)["whole"], false);
}

TEST_F(LogSummaryTest, ForeignAndBrokenMessagesAreNamed) {
  std::vector<uint8_t> foreign(30, 1);
  Write("ELSEWHERE", foreign, 1);
  std::vector<uint8_t> broken = messaging::Encode(sensor::Session{});
  broken.resize(broken.size() - 3);
  Write("GEON_SESSION", broken, 2);
  const LogSummary summary = Summarize();
  EXPECT_NE(summary.Complaint().find("ELSEWHERE carries a type that is none of ours"),
            std::string::npos);
  EXPECT_NE(summary.Complaint().find("1 message(s) on GEON_SESSION do not decode"),
            std::string::npos);
  EXPECT_EQ(summary.channels.at("ELSEWHERE").type, "?? 0101010101010101");
}

}  // namespace
}  // namespace geon::cli
