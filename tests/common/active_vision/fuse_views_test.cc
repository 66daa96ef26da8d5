#include "active_vision/fuse_views.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

using Posterior = std::array<double, kGeonLabelCount>;

// A look that gave the cuboid and the tapered cuboid these posteriors, and all others the rest.
sensor::GeonVerdict Look(double cuboid_1, double tapered_1) {
  sensor::GeonVerdict verdict;
  verdict.posterior.fill((1.0 - cuboid_1 - tapered_1) / 5.0);
  verdict.posterior[0] = cuboid_1;
  verdict.posterior[3] = tapered_1;
  verdict.label = cuboid_1 > tapered_1 ? GeonLabel::kCuboid : GeonLabel::kTaperedCuboid;
  verdict.confidence = std::max(cuboid_1, tapered_1);
  return verdict;
}

double Sum(const Posterior& posterior_1) {
  return std::accumulate(posterior_1.begin(), posterior_1.end(), 0.0);
}

TEST(FuseViews, OneViewIsWhatItWas) {
  sensor::GeonVerdict view = Look(0.6, 0.3);
  view.decided = true;
  const sensor::GeonVerdict fused = FuseViews(std::array{view}, {0.5, 0.99});
  EXPECT_EQ(fused.posterior, view.posterior);
  EXPECT_TRUE(fused.decided);
  EXPECT_EQ(fused.confidence, 0.6);
}

TEST(FuseViews, PosteriorsMultiply) {
  const sensor::GeonVerdict fused =
      FuseViews(std::array{Look(0.5, 0.4), Look(0.3, 0.6)}, {1.0, 0.6});
  const double all = 0.15 + 0.24 + 5 * 0.02 * 0.02;
  EXPECT_NEAR(fused.posterior[0], 0.15 / all, 1e-12);
  EXPECT_NEAR(fused.posterior[3], 0.24 / all, 1e-12);
  EXPECT_NEAR(Sum(fused.posterior), 1.0, 1e-12);
  EXPECT_EQ(fused.label, GeonLabel::kTaperedCuboid);
  EXPECT_EQ(fused.confidence, fused.posterior[3]);
}

TEST(FuseViews, WeightIsThePowerOfEachView) {
  const sensor::GeonVerdict fused =
      FuseViews(std::array{Look(0.5, 0.4), Look(0.3, 0.6)}, {0.5, 0.6});
  EXPECT_NEAR(fused.posterior[3] / fused.posterior[0], std::sqrt(0.24 / 0.15), 1e-12);
}

TEST(FuseViews, OrderDoesNotMatterToTheAnswer) {
  const FusionOptions options{0.7, 0.9};
  const auto a = FuseViews(std::array{Look(0.5, 0.4), Look(0.2, 0.7), Look(0.6, 0.1)}, options);
  const auto b = FuseViews(std::array{Look(0.6, 0.1), Look(0.5, 0.4), Look(0.2, 0.7)}, options);
  for (size_t k = 0; k < a.posterior.size(); ++k) {
    EXPECT_NEAR(a.posterior[k], b.posterior[k], 1e-12);
  }
}

TEST(FuseViews, DecidedByTheFusedPosteriorNotByOneView) {
  sensor::GeonVerdict sure = Look(0.9, 0.05);
  sure.decided = true;
  EXPECT_FALSE(FuseViews(std::array{Look(0.1, 0.8), sure}, {1.0, 0.9}).decided)
      << "they contradict each other";
  EXPECT_TRUE(FuseViews(std::array{Look(0.7, 0.2), Look(0.7, 0.2)}, {1.0, 0.9}).decided)
      << "they agree";
}

TEST(FuseViews, NoViewRulesAShapeOutForGood) {
  const sensor::GeonVerdict never = Look(1.0, 0.0);
  const auto fused =
      FuseViews(std::array{never, Look(0.0, 1.0), Look(0.05, 0.9), Look(0.05, 0.9)}, {1.0, 0.9});
  EXPECT_EQ(fused.label, GeonLabel::kTaperedCuboid);
  EXPECT_TRUE(std::isfinite(fused.posterior[0]));
  EXPECT_GT(fused.posterior[0], 0.0);
}

TEST(FuseViews, EvidenceAndScanAreTheNewestAndTheReasonsSayHowManySides) {
  sensor::GeonVerdict older = Look(0.6, 0.3), newest = Look(0.6, 0.3);
  older.scan_id = 1;
  newest.scan_id = 2;
  newest.reasons = {"what it saw"};
  const auto fused = FuseViews(std::array{older, newest}, {1.0, 0.9});
  EXPECT_EQ(fused.scan_id, 2);
  ASSERT_EQ(fused.reasons.size(), 2U);
  EXPECT_EQ(fused.reasons[1], "seen from 2 sides: together cuboid");
}

TEST(FuseViews, NothingThrows) { EXPECT_THROW(FuseViews({}), ContractViolation); }

TEST(TrainedFusion, IsWhatFuseViewsUses) {
  const auto views = std::array{Look(0.5, 0.4), Look(0.7, 0.2)};
  EXPECT_EQ(FuseViews(views).posterior, FuseViews(views, TrainedFusion()).posterior);
  EXPECT_EQ(FuseViews(views).decided, FuseViews(views, TrainedFusion()).decided);
}

}  // namespace
}  // namespace geon::active_vision
