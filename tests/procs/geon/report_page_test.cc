#include "procs/geon/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/procs/recognizer/board_scene.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

// A run that went well, as far as the page shows it.
RunRecord GoodRun() {
  const auto config = recognizer::TestConfig();
  recognizer::ScanAssembler assembler(config.rig, recognizer::TestCalibration(config.rig),
                                      config.assembler);
  RunRecord run;
  run.file = "logs/run.lcmlog";
  run.duration_s = 42.0;
  run.plan = recognizer::TestPlan(3);
  assembler.Take(*run.plan);
  for (int32_t k = 0; k < 6; ++k) {
    const auto answer = assembler.Take(recognizer::TestStripe(config.rig, *run.plan, k));
    run.profiles[k] = answer.profile;
    run.verdict = answer.verdict;
  }
  sensor::BaseState base;
  run.path = {base, base};
  run.path[1].x_m = 1.5;
  sensor::PlannerState state;
  state.phase = "done";
  state.text = "all is <well> & good";
  state.p_WTarget_m = Eigen::Vector2d(2.5, 0.0);
  run.last_state = state;
  run.phases = {{"search", "looking", 0.0, 10.0}, {"done", state.text, 10.0, 42.0}};
  sensor::TargetView view;
  view.scan_id = 3;
  view.target_box = sensor::PixelBox{2, 1, 4, 3};
  view.view.width_px = 8;
  view.view.height_px = 6;
  cv::imencode(".jpg", cv::Mat(6, 8, CV_8UC3, cv::Scalar(30, 60, 90)), view.view.data);
  view.mask.width_px = 8;
  cv::Mat mask(6, 8, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(2, 1, 4, 3)) = 255;
  cv::imencode(".png", mask, view.mask.data);
  run.views = {view};
  return run;
}

Truth OneGeon(GeonLabel label) {
  Truth truth;
  truth.objects = {{"geon", label, 2.5, 0.1}, {"box", std::nullopt, 1.0, 1.0}};
  return truth;
}

std::string Page(const RunRecord& run, const std::optional<Truth>& truth) {
  return ReportPage(run, recognizer::TestConfig().rig, truth);
}

TEST(ReportPage, TellsTheVerdictAndComparesItWithTheTruth) {
  const RunRecord run = GoodRun();
  ASSERT_TRUE(run.verdict.has_value());
  const GeonLabel other =
      run.verdict->label == GeonLabel::kCuboid ? GeonLabel::kEllipsoid : GeonLabel::kCuboid;
  EXPECT_THAT(Page(run, OneGeon(run.verdict->label)), HasSubstr("badge right"));
  EXPECT_THAT(Page(run, OneGeon(other)), HasSubstr("badge wrong"));
  EXPECT_THAT(Page(run, std::nullopt), Not(HasSubstr("class=\"badge")));
}

TEST(ReportPage, ShowsPictureStripesMapAndTimeline) {
  const std::string page = Page(GoodRun(), std::nullopt);
  EXPECT_THAT(page, HasSubstr("data:image/jpeg;base64,"));
  EXPECT_THAT(page, HasSubstr("class=\"mask\""));
  EXPECT_THAT(page, HasSubstr("class=\"box\""));
  size_t plots = 0;
  for (size_t at = page.find("theta-plot\""); at != std::string::npos;
       at = page.find("theta-plot\"", at + 1)) {
    ++plots;
  }
  EXPECT_EQ(plots, 6U);
  EXPECT_THAT(page, HasSubstr("map of the run"));
  EXPECT_THAT(page, HasSubstr("phase search"));
}

TEST(ReportPage, NeedsNothingFromElsewhere) {
  const std::string page = Page(GoodRun(), std::nullopt);
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
}

TEST(ReportPage, EscapesWhatProcessesSay) {
  EXPECT_THAT(Page(GoodRun(), std::nullopt), HasSubstr("all is &lt;well&gt; &amp; good"));
}

TEST(ReportPage, ARunWithoutAnythingIsToldToo) {
  const std::string page = Page({}, std::nullopt);
  EXPECT_THAT(page, HasSubstr("No geon was named"));
  EXPECT_THAT(page, HasSubstr("No stripe was measured"));
}

TEST(ReportPage, SaysThatTheLogIsDamaged) {
  RunRecord run = GoodRun();
  run.damage.torn_tail_bytes = 12;
  EXPECT_THAT(Page(run, std::nullopt), HasSubstr("The log is damaged"));
}

TEST(ReportPage, TheTruthIsThatOfTheNearestShape) {
  Truth truth = OneGeon(GeonLabel::kEllipsoid);
  truth.objects.push_back({"geon", GeonLabel::kBentCuboid, -2.0, 0.0});
  EXPECT_EQ(TrueLabel(GoodRun(), truth), GeonLabel::kEllipsoid);
}

}  // namespace
}  // namespace geon::cli
