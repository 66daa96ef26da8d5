#include "procs/geon/train_views_command.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "config/text_file.h"
#include "procs/geon/commands.h"

namespace geon::cli {
namespace {

// Runs `geon train ...`; what it says on stdout is kept.
struct TrainRun {
  explicit TrainRun(const std::string& line) {
    CLI::App app("geon");
    AddTrainCommand(app, &exit_code);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    try {
      app.parse(line);
    } catch (const CLI::ParseError& error) {
      refused = error.what();
    }
    out = testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
  }
  int exit_code = kNotReady;
  std::string refused;
  std::string out;
};

std::string FileInTemp(const std::string& name) {
  return (std::filesystem::path(testing::TempDir()) / name).string();
}

const char kFew[] =
    "train views --seed 3 --shapes 12 --calibration-shapes 10 --ordinary-shapes 10 "
    "--held-out-shapes 10 ";

TEST(TrainViewsCommand, JobsChangeNeitherTheTableNorTheReport) {
  const std::string one = FileInTemp("one.inc"), three = FileInTemp("three.inc");
  const TrainRun alone(kFew + ("--jobs 1 -o " + one));
  const TrainRun together(kFew + ("--jobs 3 -o " + three));
  EXPECT_EQ(alone.exit_code, kOk) << alone.refused;
  EXPECT_EQ(alone.out, together.out);
  const auto table = config::ReadFile(one), same = config::ReadFile(three);
  ASSERT_TRUE(table.ok() && same.ok());
  EXPECT_EQ(*table, *same);
  EXPECT_NE(table->find("--seed 3 --shapes 12"), std::string::npos);
  EXPECT_NE(alone.out.find("held out, ordinary shapes: 120 first looks"), std::string::npos)
      << alone.out;
}

TEST(TrainViewsCommand, SaysWhereItCouldNotWrite) {
  EXPECT_EQ(TrainRun(kFew + std::string("-o /nonexistent/table.inc")).exit_code, kFailed);
}

TEST(TrainViewsCommand, AnswersToItsOwnOptionsAlone) {
  EXPECT_EQ(TrainRun("train").refused, "--output is required");
  EXPECT_EQ(TrainRun("train views").refused, "--output is required");
  EXPECT_NE(TrainRun("train --seed 3 views -o " + FileInTemp("x.inc")).refused, "");
  EXPECT_NE(TrainRun("train views --trees 3 -o " + FileInTemp("x.inc")).refused, "");
}

// What `geon train` did before it had a subcommand.
TEST(TrainCommand, StillTrainsTheForest) {
  const std::string file = FileInTemp("forest.inc");
  const TrainRun run("train --seed 5 --scans 100 --calibration-scans 100 --trees 2 --depth 3 -o " +
                     file);
  EXPECT_EQ(run.exit_code, kOk) << run.refused;
  const auto source = config::ReadFile(file);
  ASSERT_TRUE(source.ok());
  EXPECT_EQ(source->rfind("// Made by `geon train --seed 5 --scans 100", 0), 0U);
  EXPECT_NE(run.out.find("2 trees"), std::string::npos);
}

}  // namespace
}  // namespace geon::cli
