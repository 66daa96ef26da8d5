#include "sim/surface_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/angles.h"
#include "sim/random_world.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

struct Comparison {
  int pixels = 0;
  int curved = 0;               // of these on round surfaces
  int other_surfaces = 0;       // another body, or more than a millimetre away: a silhouette
  double farthest_m = 0.0;      // between the points of the others
  double largest_turn_1 = 0.0;  // between their normals
};

// Every pixel of a picture against a ray of its own.
void CompareWithRays(const Scene& scene, const geometry::PinholeCamera& camera,
                     const geometry::RigidTransform& X_WC, Comparison* comparison) {
  View view;
  LookThrough(scene, camera, X_WC, &view);
  SurfaceRow row;
  const auto width = static_cast<size_t>(camera.width_px);
  std::vector<Eigen::Vector3f> rays(width);
  std::vector<Sighting> traced(width);
  for (int v = 0; v < camera.height_px; ++v) {
    for (size_t u = 0; u < width; ++u) {
      rays[u] = (X_WC.linear() * camera.Ray(static_cast<double>(u), v)).cast<float>();
    }
    scene.Look(X_WC.translation().cast<float>(), rays, traced);
    ResolveRow(scene, view, v, 0, camera.width_px, &row);
    for (const SurfaceRow::Run& run : row.runs) {
      if (run.body >= 0 && !run.flat) comparison->curved += run.end - run.begin;
      for (int u = run.begin; u < run.end; ++u) {
        ++comparison->pixels;
        const Sighting& ray = traced[static_cast<size_t>(u)];
        const double apart_m =
            ray.body < 0 ? 0.0 : static_cast<double>((ray.p_W_m - row.Point(u)).norm());
        if (ray.body != run.body || apart_m > 1e-3) {
          ++comparison->other_surfaces;
          continue;
        }
        if (ray.body < 0) continue;
        comparison->farthest_m = std::max(comparison->farthest_m, apart_m);
        const auto turn_1 = static_cast<double>((ray.normal_W - row.Normal(u)).norm());
        comparison->largest_turn_1 = std::max(comparison->largest_turn_1, turn_1);
      }
    }
  }
}

TEST(SurfaceRowTest, IsWhatRaysMeetInRandomWorlds) {
  const geometry::SensorRig rig = TestRig();
  Comparison comparison;
  for (const uint64_t seed : {7u, 21u, 22u}) {
    const World world = RandomWorld(seed, GeonPlace::kAny);
    const auto scene = *BuildScene(world);
    const WorldObject& geon = world.objects.back();
    for (const double away_m : {0.9, 1.8}) {
      const double angle_rad = 0.7 * static_cast<double>(seed) + away_m;
      const geometry::RigidTransform X_WR =
          geometry::PlanarPose(geon.x_m - away_m * std::cos(angle_rad),
                               geon.y_m - away_m * std::sin(angle_rad), angle_rad);
      // At the geon's middle, from a camera 1.3 m above the floor.
      const double tilt_rad =
          RadiansFromDegrees(15.0) - std::atan2(1.2 - FootHeight(world, geon), away_m);
      CompareWithRays(*scene, rig.color_camera, X_WR * rig.ColorCameraPose(0.05, tilt_rad),
                      &comparison);
      CompareWithRays(*scene, rig.floor_camera, X_WR * rig.X_RF, &comparison);
    }
  }
  RecordProperty("pixels", comparison.pixels);
  RecordProperty("curved", comparison.curved);
  RecordProperty("other_surfaces", comparison.other_surfaces);
  RecordProperty("farthest_m", std::to_string(comparison.farthest_m));
  RecordProperty("largest_turn_1", std::to_string(comparison.largest_turn_1));
  EXPECT_GT(comparison.curved, 100000);
  EXPECT_LE(comparison.other_surfaces, 5e-4 * comparison.pixels);
  EXPECT_LT(comparison.farthest_m, 1e-4);
  EXPECT_LT(comparison.largest_turn_1, 0.02);
}

TEST(SurfaceRowTest, RunsCoverTheColumnsAskedForAndPartAtBodies) {
  const auto scene = SceneFrom(
      "  - {box: [0.4, 0.4, 0.3], x_m: 1.5, y_m: 2.0}\n"
      "  - {geon: ellipsoid, size_m: [0.3, 0.3, 0.3], x_m: 1.5, y_m: 2.0}\n");
  const View view = LookDown(*scene, 1.5, 2.0);
  SurfaceRow row;
  ResolveRow(*scene, view, 24, 3, 60, &row);
  std::vector<int> bodies;
  int next = 3;
  for (const SurfaceRow::Run& run : row.runs) {
    EXPECT_EQ(run.begin, next);
    next = run.end;
    bodies.push_back(run.body);
    EXPECT_EQ(run.flat, run.body != 6);
  }
  EXPECT_EQ(next, 60);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  // Four walls: the box is body 5, the ellipsoid on it body 6.
  EXPECT_EQ(bodies, (std::vector<int>{0, 5, 6, 5, 0}));
}

TEST(SurfaceRowTest, PartOfARowHasTheSamePointsAsAllOfIt) {
  const auto scene =
      SceneFrom("  - {geon: ellipsoid, size_m: [0.3, 0.3, 0.3], x_m: 1.5, y_m: 2.0}\n");
  const View view = LookDown(*scene, 1.5, 2.0);
  SurfaceRow all, part;
  ResolveRow(*scene, view, 20, 0, 64, &all);
  ResolveRow(*scene, view, 20, 17, 44, &part);
  for (int u = 17; u < 44; ++u) {
    EXPECT_LT((all.Point(u) - part.Point(u)).norm(), 1e-6F);
    EXPECT_LT((all.Normal(u) - part.Normal(u)).norm(), 1e-6F);
  }
}

}  // namespace
}  // namespace geon::sim
