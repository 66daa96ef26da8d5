#include "procs/geon/supervisor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "procs/geon/process_group.h"

namespace geon::cli {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST(ParseStatesTest, ReadsRunningAndFailedProcesses) {
  const std::vector<ProcessState> states = ParseStates(
      "geon-base                        RUNNING   pid 4711, uptime 0:01:05\n"
      "geon-ptu                         BACKOFF   Exited too quickly (process log may have ...)\n"
      "unix:///x refused connection\n",
      "robot");
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].name, "geon-base");
  EXPECT_EQ(states[0].group, "robot");
  EXPECT_EQ(states[0].state, "RUNNING");
  EXPECT_EQ(states[0].pid, 4711);
  EXPECT_EQ(states[1].state, "BACKOFF");
  EXPECT_EQ(states[1].pid, 0);
  EXPECT_THAT(states[1].detail, HasSubstr("Exited too quickly"));
}

TEST(CountRestartsTest, FirstStartIsNoRestart) {
  const std::string log =
      "INFO spawned: 'geon-ptu' with pid 1\nINFO spawned: 'geon-ptu-x' with pid 2\n"
      "INFO exited: geon-ptu (terminated by SIGKILL; not expected)\n"
      "INFO spawned: 'geon-ptu' with pid 3\n";
  EXPECT_EQ(CountRestarts(log, "geon-ptu"), 1);
  EXPECT_EQ(CountRestarts(log, "geon-ptu-x"), 0);
  EXPECT_EQ(CountRestarts(log, "geon-base"), 0);
}

TEST(ProcessGroupTest, EveryGroupNamesItsProcessesAndPrograms) {
  std::set<std::string> processes;
  for (const std::string& name : ProcessGroupNames()) {
    const Result<ProcessGroup> group = LoadProcessGroup(name);
    ASSERT_TRUE(group.ok()) << group.message();
    for (const std::string& program : group->programs) EXPECT_THAT(program, HasSubstr("geon-"));
    for (const std::string& process : group->processes) {
      EXPECT_TRUE(processes.insert(process).second) << process << " is in two groups";
    }
  }
  EXPECT_THAT(processes, Contains("geon-planner"));
  EXPECT_FALSE(LoadProcessGroup("kitchen").ok());
}

TEST(ProcessGroupTest, EnvironmentGivesEveryVariableOfEveryGroup) {
  for (const bool simulated : {false, true}) {
    UpOptions options;
    options.simulated_devices = simulated;
    const Result<Environment> environment = GroupEnvironment(options);
    ASSERT_TRUE(environment.ok()) << environment.message();
    for (const std::string& name : ProcessGroupNames()) {
      std::ifstream conf(LoadProcessGroup(name)->conf);
      std::string text((std::istreambuf_iterator<char>(conf)), {});
      for (size_t at = text.find("%(ENV_"); at != std::string::npos; at = text.find("%(ENV_", at)) {
        at += 6;
        EXPECT_EQ(environment->count(text.substr(at, text.find(')', at) - at)), 1u)
            << name << ": " << text.substr(at, 30);
      }
    }
  }
}

TEST(EnvironmentFileTest, SubstitutesTheRunDirectoryAndNamesBadLines) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("geon_env_" + std::to_string(getpid()));
  std::ofstream(file) << "# comment\n\nA=${GEON_RUN_DIR}/a:${GEON_RUN_DIR}\nB=1=2\n";
  const Result<Environment> good = ReadEnvironmentFile(file, "/r");
  ASSERT_TRUE(good.ok()) << good.message();
  EXPECT_EQ(good->at("A"), "/r/a:/r");
  EXPECT_EQ(good->at("B"), "1=2");
  std::ofstream(file) << "A=1\nnonsense\n";
  EXPECT_THAT(ReadEnvironmentFile(file, "/r").message(), HasSubstr(":2: not KEY=VALUE"));
  std::filesystem::remove(file);
}

TEST(RunProgramTest, ReturnsOutputAndExitCodeAndAddsToTheEnvironment) {
  const Result<ProgramOutcome> outcome =
      RunProgram({"sh", "-c", "echo $GEON_WORD; echo bad >&2; exit 3"}, {{"GEON_WORD", "hello"}});
  ASSERT_TRUE(outcome.ok()) << outcome.message();
  EXPECT_EQ(outcome->exit_code, 3);
  EXPECT_EQ(outcome->output, "hello\nbad\n");
}

TEST(RunProgramTest, SignalAndMissingProgramAreTold) {
  EXPECT_EQ(RunProgram({"sh", "-c", "kill -9 $$"}, {})->exit_code, 137);
  EXPECT_THAT(RunProgram({"/no/such/program"}, {}).message(), HasSubstr("/no/such/program"));
}

class SupervisorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(run_);
    setenv("GEON_RUN_DIR", run_.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("GEON_RUN_DIR");
    std::filesystem::remove_all(run_);
  }
  const std::filesystem::path run_ =
      std::filesystem::temp_directory_path() / ("geon_run_" + std::to_string(getpid()));
};

TEST_F(SupervisorTest, GroupThatIsNotUpIsDownAndStopsWithoutAWord) {
  const Supervisor supervisor(*LoadProcessGroup("robot"), *GroupEnvironment({}));
  EXPECT_FALSE(supervisor.IsUp());
  EXPECT_TRUE(supervisor.Stop().ok());
  ASSERT_FALSE(supervisor.States().empty());
  EXPECT_EQ(supervisor.States()[0].state, "DOWN");
}

TEST_F(SupervisorTest, PidFileOfAProcessThatIsNotOursMeansDown) {
  std::filesystem::create_directories(run_ / "supervisor");
  std::ofstream(run_ / "supervisor" / "robot.pid") << getpid() << '\n';
  const Supervisor supervisor(*LoadProcessGroup("robot"), *GroupEnvironment({}));
  EXPECT_FALSE(supervisor.IsUp());
}

TEST_F(SupervisorTest, RunDirectoryTooLongForASocketIsRefusedInWords) {
  setenv("GEON_RUN_DIR", (run_ / std::string(120, 'x')).c_str(), 1);
  const Supervisor supervisor(*LoadProcessGroup("robot"), *GroupEnvironment({}));
  EXPECT_THAT(supervisor.Start().message(), HasSubstr("shorter GEON_RUN_DIR"));
}

}  // namespace
}  // namespace geon::cli
