#include "procs/geon/run_record.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "messaging/channels.h"
#include "tests/procs/geon/log_file.h"

namespace geon::cli {
namespace {

class RunRecordTest : public testing::Test {
 protected:
  RunRecordTest()
      : file_(std::filesystem::path(testing::TempDir()) /
              (std::string("geon_run_record_") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + ".lcmlog")) {}
  ~RunRecordTest() override { std::filesystem::remove(file_); }

  static sensor::PlannerState Planner(int32_t seq, const std::string& phase, double x_m) {
    sensor::PlannerState state;
    state.seq = seq;
    state.phase = phase;
    state.text = "while in " + phase;
    state.x_m = x_m;
    state.safe_polygon_W_m = {{x_m, 0}, {x_m + 1, 0}, {x_m, 1}};
    return state;
  }
  static sensor::BaseState Base(int32_t seq, double x_m) {
    sensor::BaseState state;
    state.seq = seq;
    state.status = sensor::DeviceStatus::kReady;
    state.x_m = x_m;
    return state;
  }
  RunRecord Read() const {
    auto run = ReadRun(file_);
    EXPECT_TRUE(run.ok()) << run.message();
    return std::move(run).value();
  }

  std::filesystem::path file_;
};

TEST_F(RunRecordTest, JoinsPhasesAndThinsThePath) {
  {
    LogFile log(file_);
    for (int32_t i = 1; i <= 10; ++i) {
      log.Write(messaging::kPlannerState, Planner(i, i <= 6 ? "search" : "scan", 0.1 * i));
      log.Write(messaging::kBaseState, Base(i, 0.005 * i));
    }
  }
  const RunRecord run = Read();
  ASSERT_EQ(run.phases.size(), 2U);
  EXPECT_EQ(run.phases[0].phase, "search");
  EXPECT_EQ(run.phases[1].text, "while in scan");
  EXPECT_DOUBLE_EQ(run.phases[0].end_s, run.phases[1].begin_s);
  EXPECT_DOUBLE_EQ(run.phases[1].end_s, run.duration_s);
  EXPECT_EQ(run.path.size(), 3U);  // at 5, 30 and 50 mm: steps of 2 cm
  EXPECT_EQ(run.safe_states.size(), 3U);
  EXPECT_EQ(run.events, 20);
}

TEST_F(RunRecordTest, CountsLossByTheHolesInSeq) {
  {
    LogFile log(file_);
    log.Write(messaging::kBaseState, Base(1, 0));
    log.Write(messaging::kBaseState, Base(5, 0));
  }
  EXPECT_EQ(Read().channels.lost(), 3);
}

TEST_F(RunRecordTest, KeepsTheGoodProfilesOfTheLastScan) {
  {
    LogFile log(file_);
    sensor::ScanPlan plan;
    plan.stripes.push_back({sensor::Laser::kHorizontal, 0.5, 0.0, 0.0});
    sensor::RangeProfile profile;
    for (int64_t scan_id = 1; scan_id <= 2; ++scan_id) {
      plan.scan_id = scan_id;
      log.Write(messaging::kScanPlan, plan);
      profile.scan_id = scan_id;
      profile.status = sensor::ProfileStatus::kMissing;
      log.Write(messaging::kRangeProfile, profile);
      profile.status = sensor::ProfileStatus::kOk;
      profile.on_target = static_cast<int32_t>(10 * scan_id);
      log.Write(messaging::kRangeProfile, profile);
    }
    profile.fraction = 0.6;  // of a sweep: one that lies farther off
    profile.on_target = 30;
    log.Write(messaging::kRangeProfile, profile);
  }
  const RunRecord run = Read();
  ASSERT_EQ(run.profiles.size(), 1U);
  EXPECT_EQ(run.profiles.at(0).on_target, 20);
  EXPECT_EQ(run.stripes_answered, 3);
}

TEST_F(RunRecordTest, RemembersTheWorstHealthAndRestarts) {
  {
    LogFile log(file_);
    sensor::Health health;
    health.process = "geon-ptu";
    health.pid = 10;
    health.level = sensor::HealthLevel::kFault;
    health.text = "no answer";
    log.Write("HEALTH_PTU", health);
    health.pid = 11;
    health.level = sensor::HealthLevel::kOk;
    health.text = "";
    log.Write("HEALTH_PTU", health);
  }
  const RunRecord run = Read();
  const ProcessHealth& ptu = run.health.at("geon-ptu");
  EXPECT_EQ(ptu.starts, 2);
  EXPECT_EQ(ptu.worst, sensor::HealthLevel::kFault);
  EXPECT_EQ(ptu.worst_text, "no answer");
  EXPECT_EQ(ptu.last.level, sensor::HealthLevel::kOk);
}

TEST_F(RunRecordTest, SaysWhichFileCannotBeRead) {
  EXPECT_NE(ReadRun("/no/such.lcmlog").message().find("/no/such.lcmlog"), std::string::npos);
}

}  // namespace
}  // namespace geon::cli
