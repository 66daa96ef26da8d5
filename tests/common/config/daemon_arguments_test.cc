#include "config/daemon_arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace geon::config {
namespace {

using ::testing::HasSubstr;

std::optional<int> ParseWords(DaemonArguments& arguments, std::vector<std::string> words) {
  words.insert(words.begin(), "geon-test");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  return arguments.Parse(static_cast<int>(argv.size()), argv.data());
}

class DaemonArgumentsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    unsetenv("GEON_CONFIG");
    unsetenv("LCM_DEFAULT_URL");
  }
  DaemonArguments arguments_{"geon-test", "Tests arguments.", "geon-test --port x"};
};

TEST_F(DaemonArgumentsTest, DefaultsAreTheInstalledRobotFileAndTheBusOfTheFile) {
  EXPECT_EQ(ParseWords(arguments_, {}), std::nullopt);
  EXPECT_TRUE(std::filesystem::exists(arguments_.config_file)) << arguments_.config_file;
  EXPECT_FALSE(arguments_.check_config);
  EXPECT_TRUE(arguments_.lcm_url.empty());
}

TEST_F(DaemonArgumentsTest, EnvironmentIsUsedAndTheCommandLineBeatsIt) {
  setenv("GEON_CONFIG", "/tmp/from_environment.yaml", 1);
  setenv("LCM_DEFAULT_URL", "udpm://239.1.1.1:1?ttl=0", 1);
  EXPECT_EQ(ParseWords(arguments_, {"--config", "/tmp/from_line.yaml", "--check-config"}),
            std::nullopt);
  EXPECT_EQ(arguments_.config_file, "/tmp/from_line.yaml");
  EXPECT_EQ(arguments_.lcm_url, "udpm://239.1.1.1:1?ttl=0");
  EXPECT_TRUE(arguments_.check_config);
}

TEST_F(DaemonArgumentsTest, HelpShowsExamplesAndExitsWithZero) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(ParseWords(arguments_, {"--help"}), 0);
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_THAT(help, HasSubstr("geon-test --port x"));
  EXPECT_THAT(help, HasSubstr("Exit codes"));
}

TEST_F(DaemonArgumentsTest, VersionNamesTheProgramAndTheBuild) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(ParseWords(arguments_, {"--version"}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "geon-test " + BuildVersion() + "\n");
  EXPECT_FALSE(BuildVersion().empty());
}

TEST_F(DaemonArgumentsTest, UnknownOptionIsAUsageError) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(ParseWords(arguments_, {"--prot", "x"}), 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--prot"));
}

TEST_F(DaemonArgumentsTest, OptionsOfOneDaemonAreReadIntoTheirValues) {
  std::string port, camera = "head";
  std::optional<uint32_t> seed;
  bool once = false;
  arguments_.AddOption("--port", &port, "serial device");
  arguments_.AddChoice("--camera", &camera, {"head", "floor"}, "which camera");
  arguments_.AddNumber("--seed", &seed, "of the noise");
  arguments_.AddFlag("--once", &once, "only once");
  EXPECT_EQ(ParseWords(arguments_, {"--port", "/dev/x", "--seed", "7", "--once"}), std::nullopt);
  EXPECT_EQ(port, "/dev/x");
  EXPECT_EQ(camera, "head");
  EXPECT_EQ(seed, 7U);
  EXPECT_TRUE(once);
  testing::internal::CaptureStderr();
  EXPECT_EQ(ParseWords(arguments_, {"--camera", "left"}), 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--camera"));
}

TEST_F(DaemonArgumentsTest, RefusalSaysWhyAndIsAUsageError) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(arguments_.RefuseConfiguration(Status::Error("robot.yaml:3: 'a' is missing")), 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("robot.yaml:3: 'a' is missing"));
}

class RobotFileTest : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }
  void TearDown() override { std::filesystem::remove(file_); }
  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                ("geon_robot_" + std::to_string(::getpid()) + ".yaml");
};

TEST_F(RobotFileTest, SectionsOfOthersAreLeftAloneAndUnknownOnesRefused) {
  const auto document = LoadRobotFile(Write("bus: {url: x}\nptu: {a: 1}\nptx: {}\n"), {"bus"});
  ASSERT_TRUE(document.ok()) << document.message();
  std::string url;
  document->root().Child("bus").Read("url", &url);
  EXPECT_THAT(document->Finish().message(), HasSubstr(":3: 'ptx' is not a known key"));
}

TEST_F(RobotFileTest, HashNamesTheContent) {
  EXPECT_EQ(FileHash(Write("")), "cbf29ce484222325");
  const std::string one = FileHash(Write("a: 1\n"));
  EXPECT_NE(one, FileHash(Write("a: 2\n")));
  EXPECT_EQ(one, FileHash(Write("a: 1\n")));
}

}  // namespace
}  // namespace geon::config
