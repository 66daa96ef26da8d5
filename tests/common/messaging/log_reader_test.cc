#include "messaging/log_reader.h"

#include <gtest/gtest.h>
#include <lcm/eventlog.h>

#include <fstream>
#include <iterator>

#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

// A log of `count` head states (seq 1, 2, ...) as lcm-logger writes it, in a file of this test's
// own.
class LogReaderTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) /
            (std::string("geon_log_reader_") + info->name() + ".lcmlog");
    lcm_eventlog_t* log = lcm_eventlog_create(file_.c_str(), "w");
    std::string channel = "PTU_STATE";
    for (int32_t seq = 1; seq <= kEvents; ++seq) {
      sensor::PtuState state;
      state.seq = seq;
      std::vector<uint8_t> bytes = Encode(state);
      lcm_eventlog_event_t event{};
      event.timestamp = 1'000'000 + seq * 1000;
      event.channellen = static_cast<int32_t>(channel.size());
      event.channel = channel.data();
      event.datalen = static_cast<int32_t>(bytes.size());
      event.data = bytes.data();
      ASSERT_EQ(lcm_eventlog_write_event(log, &event), 0);
    }
    lcm_eventlog_destroy(log);
    std::ifstream stream(file_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    event_size_ = bytes_.size() / kEvents;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  void Write() const { std::ofstream(file_, std::ios::binary) << bytes_; }
  // The seqs of all events that can be read.
  std::vector<int32_t> ReadAll(LogReader* log) const {
    std::vector<int32_t> seqs;
    while (std::optional<LogEvent> event = log->Next()) {
      const auto state = Decode<sensor::PtuState>(event->bytes);
      EXPECT_TRUE(state.ok()) << state.message();
      if (state.ok()) seqs.push_back(state->seq);
    }
    return seqs;
  }

  static constexpr int kEvents = 20;
  std::filesystem::path file_;
  std::string bytes_;
  size_t event_size_ = 0;
};

TEST_F(LogReaderTest, ReadsAWholeLog) {
  auto log = LogReader::Open(file_);
  ASSERT_TRUE(log.ok()) << log.message();
  const std::optional<LogEvent> first = log->Next();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->channel, "PTU_STATE");
  EXPECT_EQ(first->utime, 1'001'000);
  EXPECT_EQ(ReadAll(&*log).size(), kEvents - 1u);
  EXPECT_FALSE(log->damage().any());
  EXPECT_EQ(Describe(log->damage()), "whole");
  log->Rewind();
  EXPECT_EQ(ReadAll(&*log).size(), static_cast<size_t>(kEvents));
}

TEST_F(LogReaderTest, UsesWhatIsWholeOfATruncatedLog) {
  bytes_.resize(bytes_.size() - event_size_ / 2);
  Write();
  auto log = LogReader::Open(file_);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(ReadAll(&*log).size(), kEvents - 1u);
  EXPECT_EQ(log->damage().torn_tail_bytes, static_cast<int64_t>(event_size_ - event_size_ / 2));
  EXPECT_EQ(log->damage().skipped_bytes, 0);
}

TEST_F(LogReaderTest, GoesOnAfterADamagedHeader) {
  bytes_[5 * event_size_ + 1] ^= 0x10;  // sync word of event 6
  Write();
  auto log = LogReader::Open(file_);
  const std::vector<int32_t> seqs = ReadAll(&*log);
  EXPECT_EQ(seqs.size(), kEvents - 1u);
  EXPECT_EQ(log->damage().skipped_bytes, static_cast<int64_t>(event_size_));
  EXPECT_EQ(log->damage().damaged_places, 1);
  EXPECT_EQ(log->damage().missing_events, 1);
}

TEST_F(LogReaderTest, ALengthThatLeadsAstrayCostsOneEvent) {
  bytes_[5 * event_size_ + 26] = 0x7f;  // data length of event 6
  Write();
  auto log = LogReader::Open(file_);
  EXPECT_EQ(ReadAll(&*log).size(), kEvents - 1u);
  EXPECT_TRUE(log->damage().any());
}

TEST_F(LogReaderTest, GoesOnAfterGarbage) {
  bytes_.insert(7 * event_size_, std::string(100'000, '\xed'));
  Write();
  auto log = LogReader::Open(file_);
  EXPECT_EQ(ReadAll(&*log).size(), static_cast<size_t>(kEvents));
  EXPECT_EQ(log->damage().skipped_bytes, 100'000);
}

TEST_F(LogReaderTest, MissingEventsShowByNumber) {
  bytes_.erase(3 * event_size_, 2 * event_size_);
  Write();
  auto log = LogReader::Open(file_);
  EXPECT_EQ(ReadAll(&*log).size(), kEvents - 2u);
  EXPECT_EQ(log->damage().missing_events, 2);
}

TEST_F(LogReaderTest, WhatIsNoLogHasNoEvents) {
  bytes_ = "this is not a log, however long it goes on and on and on";
  Write();
  auto log = LogReader::Open(file_);
  EXPECT_FALSE(log->Next().has_value());
  EXPECT_EQ(log->damage().skipped_bytes, static_cast<int64_t>(bytes_.size()));
  EXPECT_FALSE(LogReader::Open("/nonexistent/log").ok());
  EXPECT_FALSE(LogReader::Open("/tmp").ok());
}

}  // namespace
}  // namespace geon::messaging
