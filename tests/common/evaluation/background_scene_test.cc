#include "evaluation/background_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "evaluation/point_counts.h"
#include "geons/polygon_geon.h"

namespace geon::evaluation {
namespace {

TEST(BackgroundTrial, DependsOnSeedAndNumberAlone) {
  const BackgroundTrial a = MakeBackgroundTrial(3, 8, 0.0625),
                        b = MakeBackgroundTrial(3, 8, 0.0625);
  EXPECT_EQ(a.labelled.on_object, b.labelled.on_object);
  EXPECT_EQ(a.labelled.scan.profiles[2].p_L_m, b.labelled.scan.profiles[2].p_L_m);
  EXPECT_NE(a.range_m, MakeBackgroundTrial(4, 8, 0.0625).range_m);
}

TEST(BackgroundTrial, TakesTheScenesInTurnAndLabelsEveryPoint) {
  std::set<BackgroundScene> scenes;
  for (uint64_t t = 0; t < 6; ++t) {
    const BackgroundTrial trial = MakeBackgroundTrial(1, t, 0.0625);
    scenes.insert(trial.scene);
    size_t target = 0, background = 0;
    for (size_t k = 0; k < 6; ++k) {
      const sensor::RangeProfile& profile = trial.labelled.scan.profiles[k];
      ASSERT_EQ(trial.labelled.on_object[k].size(), profile.p_L_m.size());
      ASSERT_EQ(profile.on_color_1.size(), profile.p_L_m.size());
      for (const bool on : trial.labelled.on_object[k]) ++(on ? target : background);
    }
    EXPECT_GT(target, 200U);
    EXPECT_GT(background, 200U);
  }
  EXPECT_EQ(scenes.size(), 6U);
}

// Where the robot stands upright the truth can be told from the height.
TEST(BackgroundTrial, OnALevelFloorTheObjectIsWhatIsHigher) {
  const BackgroundTrial trial = MakeBackgroundTrial(1, 0, 0.125);
  ASSERT_EQ(trial.scene, BackgroundScene::kLevel);
  for (size_t k = 0; k < 6; ++k) {
    const auto& points_m = trial.labelled.scan.profiles[k].p_L_m;
    for (size_t i = 0; i < points_m.size(); ++i) {
      if (std::abs(points_m[i].z()) < 0.03) continue;
      EXPECT_EQ(trial.labelled.on_object[k][i], points_m[i].z() > 0.0);
    }
  }
}

TEST(Surroundings, StandClearOfTheObject) {
  const auto object = geons::PolygonGeon({GeonLabel::kCuboid, {0.16, 0.16, 0.16}}, 48);
  std::mt19937_64 random(1);
  const Surroundings box = MakeSurroundings(BackgroundScene::kBox, object, 0.0, random);
  EXPECT_LE(box.floor_m, -0.3);
  EXPECT_NEAR(geons::Bounds(box.mesh).max().z(), 0.0, 1e-12);
  const Surroundings tiles = MakeSurroundings(BackgroundScene::kTiles, object, 0.0, random);
  EXPECT_NEAR(geons::Bounds(tiles.mesh).max().z(), 0.0, 1e-12);
  EXPECT_LT(tiles.floor_m, 0.0);
  const Surroundings wall = MakeSurroundings(BackgroundScene::kWall, object, 0.0, random);
  for (const auto& p_m : wall.mesh.vertices_m) EXPECT_GT(p_m.head<2>().norm(), 0.08);
  EXPECT_TRUE(MakeSurroundings(BackgroundScene::kLean, object, 0.0, random).mesh.triangles.empty());
}

}  // namespace
}  // namespace geon::evaluation
