#include "procs/simulator/simulator_arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "config/text_file.h"

namespace geon::simulator {
namespace {

using ::testing::HasSubstr;

std::string TemporaryFile(const std::string& name, const std::string& text) {
  const std::string file = ::testing::TempDir() + name;
  EXPECT_TRUE(config::WriteFileAtomically(file, text).ok());
  return file;
}

std::optional<int> ParseWords(SimulatorArguments* arguments, std::vector<std::string> words) {
  words.insert(words.begin(), "geon-sim");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  return arguments->Parse(static_cast<int>(pointers.size()), pointers.data());
}

const std::string kConfig = GEON_SOURCE_DIR "/scripts/config/";

TEST(SimulatorArgumentsTest, ReadsWorldRigAndSeed) {
  SimulatorArguments arguments;
  ASSERT_FALSE(ParseWords(&arguments,
                          {"--world", kConfig + "worlds/box.yaml", "--seed", "7", "--run-dir",
                           ::testing::TempDir() + "sim-run", "--config", kConfig + "robot.yaml"}));
  const Result<SimulatorSettings> settings = arguments.ReadSettings();
  ASSERT_TRUE(settings.ok()) << settings.message();
  EXPECT_EQ(settings->seed, 7u);
  EXPECT_EQ(settings->world.objects.size(), 2u);
  EXPECT_NEAR(settings->rig.stripe_camera.fx_px, 1600.0, 1e-9);
  EXPECT_EQ(settings->truth_file,
            std::filesystem::path(::testing::TempDir() + "sim-run/truth.jsonl"));
}

TEST(SimulatorArgumentsTest, BadWorldIsRefusedWithFileLineAndReason) {
  const std::string world =
      TemporaryFile("bad.yaml", "pen: {size_m: [3, 4.5]}\nrobot: {x_m: 9, y_m: 1}\n");
  SimulatorArguments arguments;
  ASSERT_FALSE(ParseWords(&arguments, {"--world", world}));
  EXPECT_THAT(arguments.ReadSettings().message(),
              AllOf(HasSubstr("bad.yaml:2"), HasSubstr("inside the pen")));
}

TEST(SimulatorArgumentsTest, MissingMeshIsRefusedBeforeAnythingMoves) {
  const std::string world =
      TemporaryFile("mesh.yaml",
                    "pen: {size_m: [3, 4.5]}\nrobot: {x_m: 1, y_m: 1}\n"
                    "objects:\n  - {mesh: gone.obj, height_m: 0.2, x_m: 2, y_m: 3}\n");
  SimulatorArguments arguments;
  ASSERT_FALSE(ParseWords(&arguments, {"--world", world}));
  EXPECT_THAT(arguments.ReadSettings().message(), HasSubstr("gone.obj"));
}

TEST(SimulatorArgumentsTest, UnknownFlagIsAUsageError) {
  SimulatorArguments arguments;
  EXPECT_EQ(ParseWords(&arguments, {"--wrold", "x"}), 2);
}

}  // namespace
}  // namespace geon::simulator
