#include "evaluation/random_scan.h"

#include <gtest/gtest.h>

#include "evaluation/thesis_objects.h"
#include "evaluation/trial_random.h"

namespace geon::evaluation {
namespace {

TEST(RandomShape, IsPossibleAndOfEveryClass) {
  std::mt19937_64 random(1);
  std::array<int, kGeonLabelCount> counts{};
  for (int k = 0; k < 700; ++k) {
    const geons::GeonShape shape = RandomShape(random);
    EXPECT_TRUE(geons::Validate(shape).ok());
    ++counts[static_cast<size_t>(shape.label)];
  }
  for (int count : counts) EXPECT_NEAR(count, 100, 40);
}

TEST(RandomShape, IsNoneOfTheThesissObjects) {
  for (uint64_t t = 0; t < 300; ++t) {
    std::mt19937_64 random = TrialRandom(2, t);
    const geons::GeonShape shape = RandomShape(random);
    for (const ExperimentObject& object : ThesisObjects()) {
      EXPECT_FALSE(object.shape.label == shape.label && object.shape.size_m == shape.size_m);
    }
  }
}

TEST(RandomScan, IsTheSameWhenMadeAgainAndTellsItsTruth) {
  const RandomScan a = MakeRandomScan(3, 5), b = MakeRandomScan(3, 5), c = MakeRandomScan(3, 6);
  EXPECT_EQ(a.scan.profiles[0].p_L_m, b.scan.profiles[0].p_L_m);
  EXPECT_NE(a.scan.profiles[0].p_L_m, c.scan.profiles[0].p_L_m);
  EXPECT_EQ(a.scan.truth, a.shape.label);
  EXPECT_EQ(a.scan.profiles.size(), 6U);
}

TEST(RandomScan, ComesFromBothFamilies) {
  int polygons = 0;
  for (uint64_t t = 0; t < 24; ++t) {
    if (MakeRandomScan(4, t).family == Family::kPolygon) ++polygons;
  }
  EXPECT_GT(polygons, 4);
  EXPECT_LT(polygons, 20);
}

}  // namespace
}  // namespace geon::evaluation
