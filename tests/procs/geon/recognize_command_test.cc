#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "config/scan_set_json.h"
#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/recognition_arguments.h"
#include "procs/geon/verdict_text.h"
#include "tests/procs/recognizer/board_scene.h"

namespace geon::cli {
namespace {

// Runs `geon recognize ...`; what it says on stdout is kept.
struct CommandRun {
  explicit CommandRun(const std::string& line) {
    CLI::App app("geon");
    AddRecognizeCommand(app, &exit_code);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    app.parse(line);
    out = testing::internal::GetCapturedStdout();
    err = testing::internal::GetCapturedStderr();
  }
  int exit_code = kOk;
  std::string out;
  std::string err;
};

// A scan set of a board, in a file.
std::string ScanFile() {
  const auto config = recognizer::TestConfig();
  recognizer::ScanAssembler assembler(config.rig, recognizer::TestCalibration(config.rig),
                                      config.assembler);
  const sensor::ScanPlan plan = recognizer::TestPlan(1);
  assembler.Take(plan);
  for (int32_t k = 0; k < 6; ++k) assembler.Take(recognizer::TestStripe(config.rig, plan, k));
  const std::string file = testing::TempDir() + "/geon_recognize_command_test.json";
  EXPECT_TRUE(
      config::WriteFileAtomically(file, config::SerializeScanSet(assembler.CurrentScan())).ok());
  return file;
}

TEST(RecognizeCommand, PrintsAVerdictALineInOrder) {
  const std::string file = ScanFile();
  const CommandRun run("recognize --json " + file + " " + file);
  EXPECT_EQ(run.exit_code, kOk);
  std::istringstream lines(run.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_EQ(nlohmann::json::parse(line)["format"], "geon.verdict.v1");
  }
  EXPECT_EQ(count, 2);
}

TEST(RecognizeCommand, ABadFileFailsAndTheOthersAreStillRecognised) {
  const CommandRun run("recognize --json /no/such.json " + ScanFile());
  EXPECT_EQ(run.exit_code, kFailed);
  EXPECT_NE(run.err.find("/no/such.json"), std::string::npos);
  EXPECT_NE(run.out.find("geon.verdict.v1"), std::string::npos);
}

TEST(RecognizeCommand, ToldForPeopleItGivesReasons) {
  EXPECT_NE(CommandRun("recognize " + ScanFile()).out.find("bending"), std::string::npos);
}

TEST(RecognizeCommand, RefusesAnUnknownMethod) {
  CLI::App app("geon");
  int exit_code = kOk;
  AddRecognizeCommand(app, &exit_code);
  EXPECT_THROW(app.parse("recognize --method magic x.json"), CLI::ParseError);
}

TEST(RecognitionArguments, ChangeOnlyWhatWasSaid) {
  recognition::RecognitionOptions base;
  base.curvature = recognition::CurvatureMethod::kWall;
  RecognitionArguments arguments;
  EXPECT_FALSE(arguments.any());
  EXPECT_EQ(ToOptions(arguments, base).curvature, recognition::CurvatureMethod::kWall);
  arguments.curvature = "ramer";
  EXPECT_TRUE(arguments.any());
  EXPECT_EQ(ToOptions(arguments, base).curvature, recognition::CurvatureMethod::kRamer);
}

TEST(VerdictText, NamesGeonsAsPeopleDo) {
  sensor::GeonVerdict verdict;
  verdict.label = GeonLabel::kTaperedCylinder;
  verdict.confidence = 0.456;
  verdict.reasons = {"Because."};
  EXPECT_EQ(VerdictText(verdict),
            "tapered cylinder (confidence 46 %, no more than a guess)\n  Because.\n");
}

}  // namespace
}  // namespace geon::cli
