#include "procs/geon/drawn_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

sim::World BoxCylinderAndGeon() {
  sim::World world;
  world.objects.resize(3);
  world.objects[0].shape = sim::BoxShape{{0.5, 0.4, 0.7}};
  world.objects[1].shape = sim::CylinderShape{0.1, 1.0};
  world.objects[1].x_m = 1.0;
  world.objects[2].shape = geons::GeonShape{};
  world.objects[2].x_m = 2.0;
  return world;
}

TEST(DrawnRunTest, OutlinesWhatStandsInThePen) {
  const DrawnRun run = DrawRun(7, BoxCylinderAndGeon(), {{0.5, 0.5}, {0.6, 0.9}});
  EXPECT_EQ(run.t, 7);
  ASSERT_EQ(run.outlines_m.size(), 2U);
  EXPECT_EQ(run.outlines_m[0].size(), 4U);
  for (const Eigen::Vector2d& p_m : run.outlines_m[1]) {
    EXPECT_NEAR((p_m - Eigen::Vector2d(1.0, 0.0)).norm(), 0.1, 1e-12);
  }
  ASSERT_EQ(run.geons_m.size(), 1U);
  EXPECT_EQ(run.geons_m[0], Eigen::Vector2d(2.0, 0.0));
}

TEST(DrawnRunTest, IsTheSameAfterWritingAndReading) {
  DrawnRun run = DrawRun(7, BoxCylinderAndGeon(), {{0.5, 0.5}, {0.6, 0.9}});
  EXPECT_FALSE(ToJson(run).contains("picture"));
  run.picture_uri = "data:image/jpeg;base64,AA==";
  EXPECT_EQ(ToJson(ParseDrawnRun(ToJson(run))), ToJson(run));
  EXPECT_EQ(ParseDrawnRun(ToJson(run)).picture_uri, run.picture_uri);
}

TEST(DrawnRunTest, OnlyTheFirstAreKeptWhateverTheOrder) {
  std::vector<DrawnRun> runs;
  DrawnRun run;
  for (run.t = 99; run.t >= 0; --run.t) AddDrawnRun(run, &runs);
  ASSERT_EQ(runs.size(), kMostDrawnRuns);
  EXPECT_EQ(runs.front().t, 0);
  EXPECT_EQ(runs.back().t, static_cast<int>(kMostDrawnRuns) - 1);
}

TEST(DrawnRunTest, StopsAreNumberedAndThoseAtOnePlaceShareALabel) {
  const DrawnRun run = DrawRun(7, BoxCylinderAndGeon(), {{0.5, 0.5}, {0.6, 0.9}});
  EXPECT_THAT(RunMap(run), Not(HasSubstr("stop-number")));
  const std::string map = RunMap(run, {{0.5, 0.5}, {1.5, 0.5}, {0.52, 0.5}});
  EXPECT_THAT(map, HasSubstr(">1, 3</text>"));
  EXPECT_THAT(map, HasSubstr(">2</text>"));
}

}  // namespace
}  // namespace geon::cli
