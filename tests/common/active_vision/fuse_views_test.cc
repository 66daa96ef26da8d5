#include "active_vision/fuse_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace geon::active_vision {
namespace {

sensor::GeonVerdict View(const std::array<double, kGeonLabelCount>& posterior, bool decided) {
  sensor::GeonVerdict verdict;
  verdict.posterior = posterior;
  const auto most = std::max_element(posterior.begin(), posterior.end());
  verdict.label = static_cast<GeonLabel>(most - posterior.begin());
  verdict.confidence = *most;
  verdict.decided = decided;
  return verdict;
}

TEST(FuseViewsTest, OneViewIsItself) {
  const auto view = View({0.6, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0}, false);
  const auto fused = FuseViews({&view, 1});
  EXPECT_EQ(fused.label, view.label);
  EXPECT_EQ(fused.posterior, view.posterior);
  EXPECT_FALSE(fused.decided);
}

TEST(FuseViewsTest, ViewsThatAgreeDecideWhatNoneDoesAlone) {
  const std::vector<sensor::GeonVerdict> views(2, View({0.9, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0}, false));
  const auto fused = FuseViews(views);
  EXPECT_EQ(fused.label, GeonLabel::kCuboid);
  EXPECT_NEAR(fused.confidence, 0.81 / 0.82, 1e-3);
  EXPECT_TRUE(fused.decided);
}

TEST(FuseViewsTest, TheSurerViewOutweighsTheOther) {
  const std::vector<sensor::GeonVerdict> views = {
      View({0.6, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0}, false),
      View({0.05, 0.95, 0.0, 0.0, 0.0, 0.0, 0.0}, false)};
  const auto fused = FuseViews(views);
  EXPECT_EQ(fused.label, GeonLabel::kCylinder);
  EXPECT_NEAR(std::accumulate(fused.posterior.begin(), fused.posterior.end(), 0.0), 1.0, 1e-12);
  EXPECT_EQ(fused.posterior[static_cast<size_t>(fused.label)], fused.confidence);
}

TEST(FuseViewsTest, ViewsThatContradictEachOtherDecideNothing) {
  const std::vector<sensor::GeonVerdict> views = {View({0.9, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0}, false),
                                                  View({0.1, 0.9, 0.0, 0.0, 0.0, 0.0, 0.0}, false)};
  EXPECT_FALSE(FuseViews(views).decided);
}

TEST(FuseViewsTest, NoViewRulesAShapeOutForGood) {
  std::vector<sensor::GeonVerdict> views(3, View({0.99, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0}, false));
  views.front() = View({0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, false);
  EXPECT_EQ(FuseViews(views).label, GeonLabel::kCuboid);
  EXPECT_ANY_THROW(FuseViews({}));
}

}  // namespace
}  // namespace geon::active_vision
